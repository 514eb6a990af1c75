#include "comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "worker.h"

namespace bench {

namespace {

constexpr unsigned kWorkerSeconds = 300;

// Shader caches: none at all, or directories that only this run uses.
Environment withCaches(Environment environment, bool warm, const std::string& directory) {
  if (warm) {
    environment["MESA_SHADER_CACHE_DIR"] = directory + "/mesa";
    environment["ANTEROOM_CACHE"] = "on";
    environment["ANTEROOM_CACHE_DIR"] = directory + "/anteroom";
    environment["MESA_SHADER_CACHE_DISABLE"] = "false";
  } else {
    environment["MESA_SHADER_CACHE_DISABLE"] = "true";
    environment["ANTEROOM_CACHE"] = "off";
  }
  return environment;
}

std::vector<std::string> workerArguments(const Plan& plan, const std::string& worker) {
  std::vector<std::string> arguments = {"--worker", worker, "--visit",
                                        std::to_string(plan.visitMilliseconds)};
  for (const std::string& part : plan.filter.parts) arguments.insert(arguments.end(), {"--filter", part});
  if (plan.clock == Clock::kProcessor) {
    arguments.emplace_back("--cpu");
  } else {
    arguments.insert(arguments.end(), {"--start", std::to_string(now(Clock::kWall))});
  }
  return arguments;
}

// Starts one worker and adds the medians of what it measured.
void addRound(const Plan& plan, const std::string& worker, const Environment& environment,
              ImplementationResult& result) {
  const process::Outcome outcome =
      process::run("/proc/self/exe", workerArguments(plan, worker), environment, kWorkerSeconds);
  if (outcome.status != 0) {
    result.faults.push_back(fmt::format("the {} worker ended with status {}", worker, outcome.status));
    return;
  }
  const auto report = nlohmann::json::parse(outcome.output).get<WorkerReport>();
  result.implementation = report.implementation;
  for (const Measurement& measurement : report.measurements) {
    if (!plan.filter.matches(measurement.name)) continue;
    Measurement& sum = result.measurements[measurement.name];
    sum.name = measurement.name;
    sum.unit = measurement.unit;
    sum.verdict = worst(sum.verdict, measurement.verdict);
    if (!measurement.samples.empty()) sum.samples.push_back(median(measurement.samples));
  }
}

}  // namespace

std::vector<ImplementationResult> measure(const Plan& plan) {
  std::vector<ImplementationResult> results;
  std::vector<std::string> directories;
  const process::TemporaryDirectory temporary;
  for (const Implementation& implementation : plan.implementations) {
    results.push_back({implementation.name, "?", {}, {}});
    directories.push_back(temporary.path() + "/" + implementation.name);
    for (const char* cache : {"/mesa", "/anteroom"})
      std::filesystem::create_directories(directories.back() + cache);
  }

  int round = 0;
  const auto runEach = [&](const std::string& worker, bool warm, std::vector<ImplementationResult>& into) {
    for (std::size_t turn = 0; turn < into.size(); ++turn) {
      const std::size_t i = (turn + std::size_t(round)) % into.size();
      if (into[i].faults.empty())
        addRound(plan, worker, withCaches(plan.implementations[i].environment, warm, directories[i]),
                 into[i]);
    }
  };
  const bool cold = plan.filter.matchesAny(freshNames("cold"));
  const bool warm = plan.filter.matchesAny(freshNames("warm"));
  const bool steady = plan.filter.matchesAny(steadyNames());

  if (warm) {
    std::vector<ImplementationResult> unused = results;
    runEach("warm", true, unused);
  }
  for (; round < plan.rounds; ++round) {
    fmt::print(stderr, "round {} of {}\n", round + 1, plan.rounds);
    if (cold) runEach("cold", false, results);
    if (warm) runEach("warm", true, results);
    if (steady) runEach("steady", true, results);
  }
  return results;
}

std::vector<std::string> allNames() {
  std::vector<std::string> names = steadyNames();
  for (const char* temperature : {"cold", "warm"})
    for (std::string& name : freshNames(temperature)) names.push_back(std::move(name));
  return names;
}

}  // namespace bench
