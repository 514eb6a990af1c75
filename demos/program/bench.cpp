#include "bench.h"

#include <GLES/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <iterator>

#include "counters.h"
#include "room/context.h"
#include "room/picture.h"
#include "tests/measure/picture.h"
#include "tests/measure/statistics.h"

namespace program {
namespace {

constexpr int kMissingExtension = 3;  // exit status of a worker
constexpr double kFramesASecond = 30;
constexpr int kWarmUpFrames = 3;

std::vector<measure::Implementation> implementations(const BenchOptions& options, const std::string& folder) {
  std::vector<measure::Implementation> all = options.found
                                                 ? std::vector<measure::Implementation>{{"found", {}}}
                                                 : measure::sideBySide(options.sources);
  for (measure::Implementation& each : all) each.environment = measure::withCaches(each.environment, folder);
  return all;
}

std::vector<std::string> arguments(const BenchOptions& options, std::string_view demo,
                                   const std::string& size, const std::string& picture) {
  std::vector<std::string> words = {"bench",     std::string(demo),
                                    "--size",    size,
                                    "--time",    fmt::format("{}", options.time),
                                    "--samples", fmt::format("{}", options.samples),
                                    "--frames",  fmt::format("{}", options.frames),
                                    "--worker",  picture.empty() ? "time" : picture};
  words.insert(words.end(),
               {"--particles", fmt::format("{}", options.settings.particles), "--water",
                options.settings.water, "--integrator", options.settings.integrator, "--stiffness",
                fmt::format("{}", options.settings.stiffness), "--skin", options.settings.skin});
  if (options.settings.quads) words.emplace_back("--quads");
  if (options.settings.culled) words.emplace_back("--culled");
  return words;
}

std::string faultOf(int status) {
  if (status == kMissingExtension) return "has not all extensions that it needs";
  return fmt::format("the process ended with status {}", status);
}

void addRound(Measured& measured, const BenchOptions& options, const measure::Implementation& on) {
  if (!measured.fault.empty()) return;
  const process::Outcome outcome =
      process::run("/proc/self/exe", arguments(options, measured.demo, options.size, ""), on.environment);
  if (outcome.status != 0) {
    measured.fault = faultOf(outcome.status);
    return;
  }
  const auto report = nlohmann::json::parse(outcome.output).get<WorkerReport>();
  measured.says = report.implementation;
  measured.milliseconds.insert(measured.milliseconds.end(), report.milliseconds.begin(),
                               report.milliseconds.end());
  measured.medians.push_back(measure::median(report.milliseconds));
  measured.cpu.push_back(report.cpuMilliseconds);
  measured.draws += report.draws / options.rounds;
  measured.uploads += report.uploadedKibibytes / options.rounds;
}

// One picture of each implementation against the reference renderer's, which our libraries load.
void addErrors(std::vector<Measured>& measured, const BenchOptions& options,
               const std::vector<measure::Implementation>& all, const std::string& folder) {
  const auto reference = measure::reference();
  if (!reference) {
    fmt::print(stderr, "no errors are shown: the reference renderer is not beside this program\n");
    return;
  }
  const std::string& demo = measured.front().demo;
  const auto draw = [&](const std::string& name, const process::Environment& environment) {
    const std::string file = fmt::format("{}/{}-{}.png", folder, demo, name);
    const process::Outcome outcome =
        process::run("/proc/self/exe", arguments(options, demo, options.errorSize, file), environment);
    return outcome.status == 0 ? measure::readPng(file) : measure::Picture();
  };
  const measure::Picture wanted = draw("reference", measure::withCaches(reference->environment, folder));
  if (wanted.rgba.empty()) {
    fmt::print(stderr, "{}: the reference renderer drew no picture\n", demo);
    return;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (measured[i].fault.empty())
      measured[i].error = measure::rmsDifference(draw(all[i].name, all[i].environment), wanted);
}

double cpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

void drawTimed(room::Demo& demo, const room::Context& context, const WorkerTask& task) {
  using Clock = std::chrono::steady_clock;
  WorkerReport report;
  report.implementation = fmt::format("{}, {}", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
                                      reinterpret_cast<const char*>(glGetString(GL_VERSION)));
  double cpu = 0;
  Counters before{};
  for (int frame = -kWarmUpFrames; frame < task.frames; ++frame) {
    if (frame == 0) {
      cpu = cpuMilliseconds();
      before = counted();
    }
    const auto begin = Clock::now();
    demo.frame({context.width(), context.height(), task.time + frame / kFramesASecond}, demo.stages().back());
    glFinish();
    if (frame >= 0) {
      report.milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
  }
  const Counters after = counted() - before;
  report.cpuMilliseconds = (cpuMilliseconds() - cpu) / task.frames;
  report.draws = static_cast<double>(after.draws) / task.frames;
  report.uploadedKibibytes = static_cast<double>(after.uploadedBytes) / task.frames / 1024;
  room::checkErrors("the benchmark");
  std::puts(nlohmann::json(report).dump().c_str());
}

}  // namespace

int work(const std::vector<room::DemoEntry>& demos, const WorkerTask& task) {
  const room::DemoEntry& entry = *chosenDemos(demos, task.demo).front();
  const Size size = parseSize(task.size);
  const room::Context context(size.width, size.height, task.samples);
  const std::unique_ptr<room::Demo> demo = entry.make();
  demo->configure(task.settings);
  try {
    demo->setup();
    if (task.picture.empty()) {
      drawTimed(*demo, context, task);
    } else {
      demo->frame({size.width, size.height, task.time}, demo->stages().back());
      room::writePicture(task.picture, room::readPicture(size.width, size.height));
    }
  } catch (const room::MissingExtension& missing) {
    fmt::print(stderr, "rooms: {}\n", missing.what());
    return kMissingExtension;
  }
  return 0;
}

std::vector<Measured> bench(const std::vector<room::DemoEntry>& demos, const BenchOptions& options) {
  parseSize(options.size);
  parseSize(options.errorSize);
  std::vector<std::string> names;
  for (const room::DemoEntry* entry : chosenDemos(demos, options.demo)) names.emplace_back(entry->name);
  try {
    names = options.filter.chosen(names);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  const process::TemporaryDirectory folder;
  const std::vector<measure::Implementation> all = implementations(options, folder.path());
  std::vector<Measured> result;
  for (const std::string& demo : names) {
    fmt::print(stderr, "{}\n", demo);
    std::vector<Measured> measured(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      measured[i].demo = demo;
      measured[i].implementation = all[i].name;
    }
    for (int round = 0; round < options.rounds; ++round)
      measure::takeTurns(static_cast<std::size_t>(round), all.size(),
                         [&](std::size_t i) { addRound(measured[i], options, all[i]); });
    if (!options.withoutError) addErrors(measured, options, all, folder.path());
    std::move(measured.begin(), measured.end(), std::back_inserter(result));
  }
  return result;
}

}  // namespace program
