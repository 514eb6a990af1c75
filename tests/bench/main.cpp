// anteroom-bench: measures whichever libEGL.so.1 and libGLESv1_CM.so.1 it finds, or several of them side by
// side. Everything is measured in fresh processes, interleaved, and nothing counts whose picture is wrong.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "comparison.h"
#include "scene.h"
#include "worker.h"

namespace {

using namespace bench;

struct Options {
  Plan plan;
  bool compare = false;
  bool csv = false;
  bool json = false;
  bool list = false;
  std::string mesaLibraries = ANTEROOM_SYSTEM_LIBRARIES;
  std::vector<std::string> others;
  // What a worker is told.
  std::string worker;
  Nanoseconds start = 0;
};

// NAME:VARIABLE=VALUE,VARIABLE=VALUE
Implementation parseImplementation(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  Implementation result{text.substr(0, colon), {}};
  for (std::size_t begin = colon + 1, end; begin < text.size(); begin = end + 1) {
    end = std::min(text.find(',', begin), text.size());
    const std::string setting = text.substr(begin, end - begin);
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw CLI::ValidationError("--with", "no '=' in " + setting);
    result.environment[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return result;
}

std::vector<Implementation> implementations(const Options& options) {
  std::vector<Implementation> result;
  if (options.compare) {
    const std::string ours = process::executableDirectory() + "/../lib";
    if (std::filesystem::exists(ours + "/libEGL.so.1"))
      result.push_back({"ours", {{"LD_LIBRARY_PATH", ours}}});
    else
      fmt::print(stderr, "ours is left out: no libEGL.so.1 in {}\n", ours);
    const Environment mesa = {{"LD_LIBRARY_PATH", options.mesaLibraries}, {"EGL_PLATFORM", "surfaceless"}};
    Environment zink = mesa;
    zink["LIBGL_ALWAYS_SOFTWARE"] = "1";
    zink["GALLIUM_DRIVER"] = "zink";
    result.push_back({"mesa", mesa});
    result.push_back({"zink", zink});
  } else if (options.others.empty()) {
    result.push_back({"found", {}});
  }
  for (const std::string& other : options.others) result.push_back(parseImplementation(other));
  return result;
}

void list() {
  const Scenes scenes = allScenes();
  for (const std::string& name : allNames()) {
    const auto scene =
        std::find_if(scenes.begin(), scenes.end(), [&](const auto& s) { return s->name() == name; });
    fmt::print("{:40} {}\n", name, scene == scenes.end() ? "" : (*scene)->what());
  }
}

void work(const Options& options) {
  const WorkerTask task{options.plan.filter, options.plan.clock, options.plan.visitMilliseconds,
                        options.start};
  const nlohmann::json report =
      options.worker == "steady" ? measureSteady(task) : measureFresh(task, options.worker);
  std::puts(report.dump().c_str());
}

// False when an implementation failed or drew something wrong.
bool report(Options& options) {
  options.plan.implementations = implementations(options);
  const std::vector<ImplementationResult> results = measure(options.plan);
  const std::vector<Row> rows = makeRows(results, allNames(), "mesa");
  const std::string text = options.json  ? asJson(results, rows)
                           : options.csv ? asCsv(rows)
                                         : asTable(results, rows);
  std::fputs(text.c_str(), stdout);
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.verdict.fault.empty(); }) &&
         std::all_of(results.begin(), results.end(),
                     [](const auto& result) { return result.faults.empty(); });
}

void describe(CLI::App& app, Options& options) {
  app.add_flag("--compare", options.compare,
               "ours, Mesa's native and Mesa's zink, with ratios to Mesa's native");
  app.add_option("--with", options.others, "also NAME:VARIABLE=VALUE,... (an environment); may be repeated");
  app.add_option("--mesa-libraries", options.mesaLibraries, "directory of the system's libEGL.so.1")
      ->capture_default_str();
  app.add_option("--filter", options.plan.filter.parts, "only names that contain this; may be repeated");
  app.add_option("--rounds", options.plan.rounds, "rounds of fresh processes")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--visit", options.plan.visitMilliseconds,
                 "milliseconds that a scene is repeated at a time, five frames at least")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  app.add_flag_callback(
      "--cpu", [&] { options.plan.clock = Clock::kProcessor; },
      "processor time of all threads instead of wall-clock time: steadier on a busy machine");
  app.add_flag("--csv", options.csv, "comma-separated values instead of a table");
  app.add_flag("--json", options.json, "JSON instead of a table")->excludes("--csv");
  app.add_flag("--list", options.list, "what can be measured");
  app.add_option("--worker", options.worker)->group("")->check(CLI::IsMember({"steady", "cold", "warm"}));
  app.add_option("--start", options.start)->group("");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Measures an OpenGL ES 1.1 implementation: the one that is found, or several side by side.");
  app.set_version_flag("--version", "anteroom-bench " ANTEROOM_VERSION);
  try {
    describe(app, options);
    app.parse(argc, argv);
    if (!options.worker.empty()) {
      work(options);
    } else if (options.list) {
      list();
    } else if (!report(options)) {
      return 1;
    }
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 2 : 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-bench: {}\n", error.what());
    return 1;
  }
}
