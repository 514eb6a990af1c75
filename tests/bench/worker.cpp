#include "worker.h"

#include <GLES/gl.h>

#include <algorithm>
#include <fstream>

#include "scene.h"
#include "session.h"
#include "state_mixes.h"

namespace bench {

namespace {

constexpr int kVisits = 3;
constexpr int kWarmUpFrames = 3;
constexpr int kLeastFrames = 5;
constexpr const char* kSteadyMemory = "memory.steady";

// The high-water mark of resident memory, proc(5).
double peakMebibytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

// Fills `result` with the times of one visit, or with what was wrong with the picture.
void visit(const WorkerTask& task, Scene& scene, EGLDisplay display, Measurement& result) {
  const Session session(display);
  scene.begin();
  unsigned number = 0;
  for (; number < kWarmUpFrames; ++number) {
    scene.frame(number);
    glFinish();
  }
  const Stopwatch whole(Clock::kWall);
  for (int frames = 0; frames < kLeastFrames || whole.milliseconds() < task.visitMilliseconds; ++frames) {
    const Stopwatch stopwatch(task.clock);
    scene.frame(++number);
    glFinish();
    result.samples.push_back(stopwatch.milliseconds());
  }
  result.verdict = worst(result.verdict, scene.check(number));
}

Measurement measureMix(Clock clock, const StateMix& mix, const std::string& prefix) {
  resetMixState();
  glFinish();
  const Stopwatch stopwatch(clock);
  mix.apply();
  drawMixQuad();
  glFinish();
  Measurement result{prefix + mix.name, "ms", {stopwatch.milliseconds()}, {}};
  Picture picture;
  picture.expect(kWidth / 2 - 100, kHeight / 2 - 50, mix.wanted, 3);
  picture.expect(kWidth / 2 + 90, kHeight / 2 + 60, mix.wanted, 3);
  picture.expect(5, 5, {0, 0, 0});
  result.verdict = picture.verdict();
  return result;
}

std::string startPrefix(const std::string& temperature) {
  return "start." + temperature + ".";
}
std::string mixPrefix(const std::string& temperature) {
  return "first_use." + temperature + ".";
}
std::string memoryName(const std::string& temperature) {
  return "memory.first_frame." + temperature;
}

}  // namespace

std::vector<std::string> steadyNames() {
  std::vector<std::string> names;
  for (const auto& scene : allScenes()) names.push_back(scene->name());
  names.emplace_back(kSteadyMemory);
  return names;
}

std::vector<std::string> freshNames(const std::string& temperature) {
  std::vector<std::string> names;
  for (const char* name : {"context", "first_draw", "process"})
    names.push_back(startPrefix(temperature) + name);
  names.push_back(memoryName(temperature));
  for (const StateMix& mix : stateMixes()) names.push_back(mixPrefix(temperature) + mix.name);
  names.push_back(mixPrefix(temperature) + "all");
  return names;
}

WorkerReport measureSteady(const WorkerTask& task) {
  Scenes scenes = allScenes();
  std::erase_if(scenes, [&](const auto& scene) { return !task.filter.matches(scene->name()); });

  WorkerReport report;
  const EGLDisplay display = openDisplay();
  {
    const Session session(display);
    report.implementation = implementationName(display);
  }
  for (const auto& scene : scenes) report.measurements.push_back({scene->name(), "ms", {}, {}});
  for (int pass = 0; pass < kVisits; ++pass)
    for (std::size_t i = 0; i < scenes.size(); ++i)
      if (report.measurements[i].verdict.fault.empty())
        visit(task, *scenes[i], display, report.measurements[i]);
  report.measurements.push_back({kSteadyMemory, "MiB", {peakMebibytes()}, {}});
  eglTerminate(display);
  return report;
}

WorkerReport measureFresh(const WorkerTask& task, const std::string& temperature) {
  WorkerReport report;
  auto& results = report.measurements;
  const std::string prefix = startPrefix(temperature);

  const Stopwatch sinceMain(task.clock);
  const EGLDisplay display = openDisplay();
  {
    const Session session(display);
    results.push_back({prefix + "context", "ms", {sinceMain.milliseconds()}, {}});
    beginMixes();
    resetMixState();
    const Stopwatch sinceDraw(task.clock);
    drawMixQuad();
    glFinish();
    results.push_back({prefix + "first_draw", "ms", {sinceDraw.milliseconds()}, {}});
    results.push_back(
        {prefix + "process", "ms", {Stopwatch(task.clock, task.processStart).milliseconds()}, {}});
    results.push_back({memoryName(temperature), "MiB", {peakMebibytes()}, {}});
    Picture picture;
    picture.expect(kWidth / 2, kHeight / 2, {255, 255, 255});
    results.back().verdict = picture.verdict();
    report.implementation = implementationName(display);

    Measurement all{mixPrefix(temperature) + "all", "ms", {0}, {}};
    for (const StateMix& mix : stateMixes()) {
      results.push_back(measureMix(task.clock, mix, mixPrefix(temperature)));
      all.samples[0] += results.back().samples[0];
      all.verdict = worst(all.verdict, results.back().verdict);
    }
    results.push_back(all);
  }
  eglTerminate(display);
  return report;
}

}  // namespace bench
