// anteroom-bench: measures whichever libEGL.so.1 and libGLESv1_CM.so.1 it finds, or several of them side by
// side. Everything is measured in fresh processes, interleaved, and nothing counts whose picture is wrong.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>

#include "comparison.h"
#include "scene.h"
#include "worker.h"

namespace {

using namespace bench;

struct Options {
  Plan plan;
  measure::Sources sources;
  measure::Format format = measure::Format::Text;
  bool compare = false;
  bool list = false;
  // What a worker is told.
  std::string worker;
  Nanoseconds start = 0;
};

std::vector<measure::Implementation> implementations(const Options& options) {
  if (options.compare) return measure::sideBySide(options.sources);
  std::vector<measure::Implementation> result = measure::others(options.sources);
  if (result.empty()) result.push_back({"found", {}});
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
  const std::vector<ImplementationResult> results = measureAll(options.plan);
  const measure::Table table = tableOf(results, allNames(), "mesa");
  const std::string text = options.format == measure::Format::Json  ? asJson(results, table)
                           : options.format == measure::Format::Csv ? table.csv()
                                                                    : asText(results, table);
  std::fputs(text.c_str(), stdout);
  return good(results);
}

void describe(CLI::App& app, Options& options) {
  app.add_flag("--compare", options.compare,
               "ours, Mesa's native and Mesa's zink, with ratios to Mesa's native");
  measure::addSources(app, options.sources);
  measure::addFilter(app, options.plan.filter);
  measure::addRounds(app, options.plan.rounds);
  app.add_option("--visit", options.plan.visitMilliseconds,
                 "milliseconds that a scene is repeated at a time, five frames at least")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  app.add_flag_callback(
      "--cpu", [&] { options.plan.clock = Clock::kProcessor; },
      "processor time of all threads instead of wall-clock time: steadier on a busy machine");
  measure::addFormat(app, options.format);
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
    return measure::kUsage;
  }
}
