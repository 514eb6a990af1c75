#include "comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "tests/measure/statistics.h"
#include "worker.h"

namespace bench {

namespace {

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
void addRound(const Plan& plan, const std::string& worker, const process::Environment& environment,
              ImplementationResult& result) {
  const process::Outcome outcome = process::run("/proc/self/exe", workerArguments(plan, worker), environment);
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
    if (!measurement.samples.empty()) sum.samples.push_back(measure::median(measurement.samples));
  }
}

}  // namespace

std::vector<ImplementationResult> measureAll(const Plan& plan) {
  plan.filter.chosen(allNames());
  std::vector<ImplementationResult> results;
  std::vector<process::Environment> colds, warms;
  const process::TemporaryDirectory temporary;
  for (const auto& [name, environment] : plan.implementations) {
    results.push_back({name, "?", {}, {}});
    colds.push_back(measure::withoutCaches(environment));
    warms.push_back(measure::withCaches(environment, temporary.path() + "/" + name));
  }

  std::size_t round = 0;
  const auto runEach = [&](const std::string& worker, const std::vector<process::Environment>& environments,
                           std::vector<ImplementationResult>& into) {
    measure::takeTurns(round, into.size(), [&](std::size_t i) {
      if (into[i].faults.empty()) addRound(plan, worker, environments[i], into[i]);
    });
  };
  const auto wanted = [&plan](const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return plan.filter.matches(name); });
  };
  const bool cold = wanted(freshNames("cold")), warm = wanted(freshNames("warm"));
  const bool steady = wanted(steadyNames());

  if (warm) {
    std::vector<ImplementationResult> unused = results;
    runEach("warm", warms, unused);
  }
  for (; round < static_cast<std::size_t>(plan.rounds); ++round) {
    fmt::print(stderr, "round {} of {}\n", round + 1, plan.rounds);
    if (cold) runEach("cold", colds, results);
    if (warm) runEach("warm", warms, results);
    if (steady) runEach("steady", warms, results);
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
