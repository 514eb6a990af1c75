// anteroom-compare: every scene on ours, on the float64 reference and on Mesa, with errors beside run times.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "comparison.h"
#include "worker.h"

namespace {

using namespace comparison;

struct Options {
  Plan plan;
  WorkerTask worker;
  bool csv = false, json = false, list = false;
  bool mesa = true, zink = false, minimal = false;
  std::string mesaLibraries = ANTEROOM_SYSTEM_LIBRARIES;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("--filter", options.plan.filters, "only names that contain this; may be repeated");
  app.add_option("--out", options.plan.out,
                 "folder for pictures: reference and others side by side, then errors");
  app.add_option("--repeats", options.plan.repeats, "how often a scene is drawn; the last time is reported")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_flag("--csv", options.csv, "comma-separated values instead of a table");
  app.add_flag("--json", options.json, "JSON instead of a table")->excludes("--csv");
  app.add_flag("--demos", options.plan.demos, "frames of the demos as well");
  app.add_flag("--list", options.list, "the scenes and their sections");
  app.add_flag("--mesa,!--no-mesa", options.mesa, "Mesa's native ES 1.1 as well");
  app.add_flag("--zink", options.zink, "Mesa's zink as well");
  app.add_flag("--minimal", options.minimal, "ours on Vulkan 1.1 alone as well");
  app.add_option("--mesa-libraries", options.mesaLibraries, "directory of the system's libEGL.so.1")
      ->capture_default_str();
  app.add_option("--worker", options.worker.directory)->group("");
  app.add_option("--scene", options.worker.scenes)->group("");
  app.add_flag("--varied", options.worker.varied)->group("");
  app.add_option("--lod-error", options.worker.lodError)->group("");
}

void addImplementations(Options& options) {
  const Environment ours = {{"LD_LIBRARY_PATH", process::executableDirectory() + "/../lib"}};
  const auto with = [](Environment environment, const Environment& more) {
    environment.insert(more.begin(), more.end());
    return environment;
  };
  const Environment mesa = {{"LD_LIBRARY_PATH", options.mesaLibraries}, {"EGL_PLATFORM", "surfaceless"}};
  std::vector<Implementation>& all = options.plan.implementations;
  options.plan.reference = with(ours, {{"ANTEROOM_RENDERER", "reference"}});
  all.push_back({"ours", ours});
  if (options.mesa) all.push_back({"mesa", mesa});
  if (options.zink)
    all.push_back({"zink", with(mesa, {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"GALLIUM_DRIVER", "zink"}})});
  if (options.minimal) all.push_back({"minimal", with(ours, {{"ANTEROOM_MINIMAL", "1"}})});
}

int compareAndReport(Options& options) {
  addImplementations(options);
  if (!options.plan.out.empty()) std::filesystem::create_directories(options.plan.out);
  const Comparison comparison = compareAll(options.plan);
  const std::vector<Row>& rows = comparison.rows;
  const std::string text = options.json  ? asJson(rows, options.plan)
                           : options.csv ? asCsv(rows, options.plan)
                                         : asTable(comparison, options.plan);
  std::fputs(text.c_str(), stdout);
  const bool good = std::all_of(rows.begin(), rows.end(), [](const Row& row) {
    return row.failures.empty() == row.deviates.empty() && !mesaIsExacter(row) &&
           (row.disagreements == 0 || !row.mesaDiffers.empty());
  });
  return good && !rows.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Compares pictures of ours, of the float64 reference and of Mesa"};
  app.set_version_flag("--version", "anteroom-compare " ANTEROOM_VERSION);
  try {
    describe(app, options);
    app.parse(argc, argv);
    if (options.list) {
      for (const Scene& scene : allScenes()) fmt::print("{:40} {}\n", scene.name, scene.section);
      return 0;
    }
    if (!options.worker.directory.empty()) {
      options.worker.repeats = options.plan.repeats;
      work(options.worker);
      return 0;
    }
    return compareAndReport(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 2 : 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-compare: {}\n", error.what());
    return 1;
  }
}
