// anteroom-bench: measures whichever libEGL.so.1 and libGLESv1_CM.so.1 it finds, or several of them side by
// side. Everything is measured in fresh processes, interleaved, and nothing counts whose picture is wrong.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <regex>

#include "process.h"
#include "report.h"
#include "scene.h"
#include "worker.h"

namespace {

using namespace bench;

constexpr unsigned kWorkerSeconds = 300;

struct Implementation {
  std::string name;
  Environment environment;
};

struct Options {
  bool compare = false;
  bool csv = false;
  bool json = false;
  bool list = false;
  int rounds = 5;
  std::string filter = ".";
  std::string mesaLibraries = ANTEROOM_SYSTEM_LIBRARIES;
  std::vector<std::string> others;
  // What a worker is told.
  std::string worker;
  std::int64_t start = 0;
};

bool anyMatches(const std::vector<std::string>& names, const std::string& filter) {
  const std::regex wanted(filter);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return std::regex_search(name, wanted); });
}

// NAME:VARIABLE=VALUE,VARIABLE=VALUE
Implementation parseImplementation(const std::string& text) {
  const std::size_t colon = text.find(':');
  Implementation result{text.substr(0, colon), {}};
  for (const std::string& setting :
       CLI::detail::split(colon == std::string::npos ? "" : text.substr(colon + 1), ',')) {
    if (setting.empty()) continue;
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw CLI::ValidationError("--with", "no '=' in " + setting);
    result.environment[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return result;
}

std::vector<Implementation> implementations(const Options& options) {
  std::vector<Implementation> result;
  if (options.compare) {
    const Environment mesa = {{"LD_LIBRARY_PATH", options.mesaLibraries}, {"EGL_PLATFORM", "surfaceless"}};
    Environment zink = mesa;
    zink["LIBGL_ALWAYS_SOFTWARE"] = "1";
    zink["GALLIUM_DRIVER"] = "zink";
    result = {
        {"ours", {{"LD_LIBRARY_PATH", executableDirectory() + "/../lib"}}}, {"mesa", mesa}, {"zink", zink}};
  } else if (options.others.empty()) {
    result = {{"found", {}}};
  }
  for (const std::string& other : options.others) result.push_back(parseImplementation(other));
  return result;
}

// Shader caches: none at all, or directories that only this run uses.
Environment withCaches(Environment environment, bool warm, const std::string& directory) {
  if (warm) {
    environment["MESA_SHADER_CACHE_DIR"] = directory + "/mesa";
    environment["ANTEROOM_CACHE_DIR"] = directory + "/anteroom";
    environment["MESA_SHADER_CACHE_DISABLE"] = "false";
  } else {
    environment["MESA_SHADER_CACHE_DISABLE"] = "true";
    environment["ANTEROOM_CACHE"] = "off";
  }
  return environment;
}

WorkerReport runWorker(const Options& options) {
  return options.worker == "steady" ? measureSteady(options.filter)
                                    : measureFresh(options.worker, options.start);
}

// Starts one worker and adds the medians of what it measured.
void addRound(const std::string& worker, const Environment& environment, const std::string& filter,
              ImplementationResult& result) {
  const Outcome outcome = runSelf({"--worker", worker, "--filter", filter, "--start", std::to_string(now())},
                                  environment, kWorkerSeconds);
  if (outcome.status != 0) {
    result.faults.push_back(fmt::format("the {} worker ended with status {}", worker, outcome.status));
    return;
  }
  const auto report = nlohmann::json::parse(outcome.output).get<WorkerReport>();
  result.implementation = report.implementation;
  const std::regex wanted(filter);
  for (const Measurement& measurement : report.measurements) {
    if (!std::regex_search(measurement.name, wanted)) continue;
    Measurement& sum = result.measurements[measurement.name];
    sum.name = measurement.name;
    sum.unit = measurement.unit;
    if (sum.fault.empty()) sum.fault = measurement.fault;
    if (!measurement.samples.empty()) sum.samples.push_back(median(measurement.samples));
  }
}

std::vector<ImplementationResult> measure(const Options& options) {
  const std::vector<Implementation> candidates = implementations(options);
  std::vector<ImplementationResult> results;
  std::vector<std::string> directories;
  const TemporaryDirectory temporary;
  for (const Implementation& candidate : candidates) {
    results.push_back({candidate.name, "?", {}, {}});
    directories.push_back(temporary.path() + "/" + candidate.name);
    for (const char* cache : {"/mesa", "/anteroom"})
      std::filesystem::create_directories(directories.back() + cache);
  }
  const auto each = [&](const std::string& worker, bool warm, std::vector<ImplementationResult>& into) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (into[i].faults.empty())
        addRound(worker, withCaches(candidates[i].environment, warm, directories[i]), options.filter,
                 into[i]);
  };
  const bool cold = anyMatches(freshNames("cold"), options.filter);
  const bool warm = anyMatches(freshNames("warm"), options.filter);
  const bool steady = anyMatches(steadyNames(), options.filter);

  if (warm) {
    std::vector<ImplementationResult> unused = results;
    each("warm", true, unused);
  }
  for (int round = 0; round < options.rounds; ++round) {
    fmt::print(stderr, "round {} of {}\n", round + 1, options.rounds);
    if (cold) each("cold", false, results);
    if (warm) each("warm", true, results);
    if (steady) each("steady", true, results);
  }
  return results;
}

void list() {
  for (const auto& scene : allScenes()) fmt::print("{:26} {}\n", scene->name(), scene->what());
  fmt::print("memory.steady\n");
  for (const char* temperature : {"cold", "warm"})
    for (const std::string& name : freshNames(temperature)) fmt::print("{}\n", name);
}

// 0 when every implementation drew everything right.
int compareOrMeasure(const Options& options) {
  const std::vector<ImplementationResult> results = measure(options);
  std::vector<std::string> order = steadyNames();
  for (const char* temperature : {"cold", "warm"})
    for (std::string& name : freshNames(temperature)) order.push_back(std::move(name));
  const std::vector<Row> rows = makeRows(results, order, "mesa");

  const std::string text = options.json  ? asJson(results, rows)
                           : options.csv ? asCsv(rows)
                                         : asTable(results, rows);
  std::fputs(text.c_str(), stdout);
  const bool wrong =
      std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.fault.empty(); }) ||
      std::any_of(results.begin(), results.end(), [](const auto& result) { return !result.faults.empty(); });
  return wrong ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Measures an OpenGL ES 1.1 implementation: the one that is found, or several side by side.");
  app.add_flag("--compare", options.compare,
               "ours, Mesa's native and Mesa's zink, with ratios to Mesa's native");
  app.add_option("--with", options.others, "also NAME:VARIABLE=VALUE,... (an environment); may be repeated");
  app.add_option("--mesa-libraries", options.mesaLibraries, "directory of the system's libEGL.so.1")
      ->capture_default_str();
  app.add_option("--filter", options.filter, "regular expression that names must contain");
  app.add_option("--rounds", options.rounds, "rounds of fresh processes")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_flag("--csv", options.csv, "comma-separated values instead of a table");
  app.add_flag("--json", options.json, "JSON instead of a table");
  app.add_flag("--list", options.list, "what can be measured");
  app.add_option("--worker", options.worker)->group("")->check(CLI::IsMember({"steady", "cold", "warm"}));
  app.add_option("--start", options.start)->group("");

  try {
    app.parse(argc, argv);
    if (options.list) {
      list();
      return 0;
    }
    if (options.worker.empty()) return compareOrMeasure(options);
    const nlohmann::json report = runWorker(options);
    std::puts(report.dump().c_str());
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-bench: {}\n", error.what());
    return 2;
  }
}
