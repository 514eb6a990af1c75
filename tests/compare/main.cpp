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
  measure::Sources sources;
  measure::Format format = measure::Format::Text;
  bool list = false;
  bool mesa = true, zink = false, minimal = false;
};

void describe(CLI::App& app, Options& options) {
  measure::addFilter(app, options.plan.filter);
  measure::addRounds(app, options.plan.rounds);
  app.add_option("--out", options.plan.out,
                 "folder for pictures: reference and others side by side, then errors");
  app.add_option("--repeats", options.plan.repeats, "how often a scene is drawn; the last time is reported")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  measure::addFormat(app, options.format);
  app.add_flag("--demos", options.plan.demos, "frames of the demos as well");
  app.add_flag("--list", options.list, "the scenes and their sections");
  app.add_flag("--mesa,!--no-mesa", options.mesa, "Mesa's native ES 1.1 as well");
  app.add_flag("--zink", options.zink, "Mesa's zink as well");
  app.add_flag("--minimal", options.minimal, "ours on Vulkan 1.1 alone as well");
  measure::addSources(app, options.sources);
  app.add_option("--worker", options.worker.directory)->group("");
  app.add_option("--scene", options.worker.scenes)->group("");
  app.add_flag("--varied", options.worker.varied)->group("");
  app.add_option("--lod-error", options.worker.lodError)->group("");
}

// Throws std::runtime_error where ours are not there: all is held against the reference, which they load.
void addImplementations(Options& options) {
  const auto ours = measure::ours(), reference = measure::reference();
  if (!ours || !reference)
    throw std::runtime_error("our libraries or the reference are not beside this program");
  options.plan.reference = reference->environment;
  std::vector<measure::Implementation>& all = options.plan.implementations;
  all.push_back(*ours);
  if (options.mesa) all.push_back(measure::mesa(options.sources.mesaLibraries));
  if (options.zink) all.push_back(measure::zink(options.sources.mesaLibraries));
  if (options.minimal)
    all.push_back({"minimal", measure::with(ours->environment, {{"ANTEROOM_MINIMAL", "1"}})});
  for (measure::Implementation& other : measure::others(options.sources)) all.push_back(std::move(other));
}

int compareAndReport(Options& options) {
  addImplementations(options);
  if (!options.plan.out.empty()) std::filesystem::create_directories(options.plan.out);
  const Comparison comparison = compareAll(options.plan);
  const std::vector<Row>& rows = comparison.rows;
  const measure::Table table = tableOf(rows, options.plan);
  const std::string text = options.format == measure::Format::Json  ? table.json().dump(1) + "\n"
                           : options.format == measure::Format::Csv ? table.csv()
                                                                    : asText(comparison, options.plan);
  std::fputs(text.c_str(), stdout);
  const bool good = std::all_of(rows.begin(), rows.end(), [](const Row& row) {
    return row.failures.empty() == row.deviates.empty() && !mesaIsExacter(row) &&
           (row.disagreements == 0 || !row.mesaDiffers.empty());
  });
  return good ? 0 : 1;
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
    return measure::kUsage;
  }
}
