#include "bench.h"

#include <GLES/gl.h>
#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>

#include "counters.h"
#include "process.h"
#include "room/context.h"
#include "room/picture.h"

namespace program {
namespace {

constexpr int kMissingExtension = 3;  // exit status of a worker
constexpr unsigned kSeconds = 900;    // after which a worker has failed
constexpr double kFramesASecond = 30;
constexpr int kWarmUpFrames = 3;

struct Implementation {
  std::string name;
  process::Environment environment;
};

std::vector<Implementation> implementations(const BenchOptions& options, const process::Environment& caches) {
  if (options.found) return {{"found", caches}};
  std::vector<Implementation> all;
  const auto with = [&caches](process::Environment environment) {
    environment.insert(caches.begin(), caches.end());
    return environment;
  };
  const std::string ours = process::executableDirectory() + "/../lib";
  if (std::filesystem::exists(ours + "/libEGL.so.1")) {
    all.push_back({"ours", with({{"LD_LIBRARY_PATH", ours}})});
  } else {
    fmt::print(stderr, "ours is left out: no libEGL.so.1 in {}\n", ours);
  }
  const process::Environment mesa = {{"LD_LIBRARY_PATH", options.mesaLibraries},
                                     {"EGL_PLATFORM", "surfaceless"}};
  process::Environment zink = mesa;
  zink["LIBGL_ALWAYS_SOFTWARE"] = "1";
  zink["GALLIUM_DRIVER"] = "zink";
  all.push_back({"mesa", with(mesa)});
  all.push_back({"zink", with(zink)});
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

// Root of the mean square of all channels' differences, in 1/255.
double difference(const std::string& a, const std::string& b) {
  OIIO::ImageBuf first(a);
  OIIO::ImageBuf second(b);
  if (!first.read(0, 0, true, OIIO::TypeDesc::FLOAT) || !second.read(0, 0, true, OIIO::TypeDesc::FLOAT))
    return -1;
  const OIIO::ImageSpec& spec = first.spec();
  if (spec.width != second.spec().width || spec.height != second.spec().height) return -1;
  const auto* p = static_cast<const float*>(first.localpixels());
  const auto* q = static_cast<const float*>(second.localpixels());
  const std::size_t count = spec.image_pixels() * static_cast<std::size_t>(spec.nchannels);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += static_cast<double>(p[i] - q[i]) * static_cast<double>(p[i] - q[i]);
  return 255 * std::sqrt(sum / static_cast<double>(count));
}

// All rounds of one demo on one implementation.
struct Measured {
  WorkerReport sum;  // of the rounds; the numbers a frame are sums, too
  int rounds = 0;
  std::string fault;
};

void addRound(Measured& measured, const BenchOptions& options, std::string_view demo,
              const Implementation& on) {
  if (!measured.fault.empty()) return;
  const process::Outcome outcome =
      process::run("/proc/self/exe", arguments(options, demo, options.size, ""), on.environment, kSeconds);
  if (outcome.status != 0) {
    measured.fault = faultOf(outcome.status);
    return;
  }
  const auto report = nlohmann::json::parse(outcome.output).get<WorkerReport>();
  WorkerReport& sum = measured.sum;
  sum.implementation = report.implementation;
  sum.milliseconds.insert(sum.milliseconds.end(), report.milliseconds.begin(), report.milliseconds.end());
  sum.cpuMilliseconds += report.cpuMilliseconds;
  sum.draws += report.draws;
  sum.uploadedKibibytes += report.uploadedKibibytes;
  ++measured.rounds;
}

BenchRow rowOf(std::string_view demo, const std::string& implementation, const Measured& measured) {
  BenchRow row;
  row.demo = demo;
  row.implementation = implementation;
  row.fault = measured.fault;
  if (!row.fault.empty()) return row;
  const WorkerReport& sum = measured.sum;
  row.says = sum.implementation;
  row.median = percentile(sum.milliseconds, 0.5);
  row.first = percentile(sum.milliseconds, 0.01);
  row.ninetyNinth = percentile(sum.milliseconds, 0.99);
  row.worst = percentile(sum.milliseconds, 1);
  row.cpu = sum.cpuMilliseconds / measured.rounds;
  row.draws = sum.draws / measured.rounds;
  row.uploads = sum.uploadedKibibytes / measured.rounds;
  return row;
}

// Of the rows from `first` on, which are of one demo.
void addRatios(std::vector<BenchRow>& rows, std::size_t first) {
  const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(first);
  const auto mesa =
      std::find_if(begin, rows.end(), [](const BenchRow& row) { return row.implementation == "mesa"; });
  if (mesa == rows.end() || !mesa->fault.empty()) return;
  const BenchRow baseline = *mesa;
  for (auto row = begin; row != rows.end(); ++row) {
    row->ratio = row->median / baseline.median;
    row->cpuRatio = row->cpu / baseline.cpu;
  }
}

// One picture of each implementation against the reference renderer's, which our libraries load.
void addErrors(std::vector<BenchRow>& rows, std::string_view demo, const BenchOptions& options,
               const std::vector<Implementation>& all, const std::string& folder,
               const process::Environment& caches) {
  const std::string ours = process::executableDirectory() + "/../lib";
  if (!std::filesystem::exists(ours + "/libanteroom_reference.so")) {
    fmt::print(stderr, "no errors are shown: no libanteroom_reference.so in {}\n", ours);
    return;
  }
  const auto draw = [&](const std::string& name, const process::Environment& environment) {
    const std::string file = fmt::format("{}/{}-{}.png", folder, demo, name);
    const process::Outcome outcome = process::run(
        "/proc/self/exe", arguments(options, demo, options.errorSize, file), environment, kSeconds);
    return outcome.status == 0 ? file : std::string();
  };
  process::Environment environment = {{"LD_LIBRARY_PATH", ours}, {"ANTEROOM_RENDERER", "reference"}};
  environment.insert(caches.begin(), caches.end());
  const std::string wanted = draw("reference", environment);
  if (wanted.empty()) {
    fmt::print(stderr, "{}: the reference renderer drew no picture\n", demo);
    return;
  }
  for (const Implementation& implementation : all) {
    for (BenchRow& row : rows) {
      if (row.demo != demo || row.implementation != implementation.name || !row.fault.empty()) continue;
      const std::string file = draw(implementation.name, implementation.environment);
      if (!file.empty()) row.error = difference(file, wanted);
    }
  }
}

double cpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

void measure(room::Demo& demo, const room::Context& context, const WorkerTask& task) {
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

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (values[above] - values[below]) * (at - static_cast<double>(below));
}

int work(const std::vector<room::DemoEntry>& demos, const WorkerTask& task) {
  const room::DemoEntry& entry = *chosenDemos(demos, task.demo).front();
  const Size size = parseSize(task.size);
  const room::Context context(size.width, size.height, task.samples);
  const std::unique_ptr<room::Demo> demo = entry.make();
  demo->configure(task.settings);
  try {
    demo->setup();
    if (task.picture.empty()) {
      measure(*demo, context, task);
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

std::vector<BenchRow> bench(const std::vector<room::DemoEntry>& demos, const BenchOptions& options) {
  parseSize(options.size);
  parseSize(options.errorSize);
  const process::TemporaryDirectory folder;
  const process::Environment caches = {{"MESA_SHADER_CACHE_DIR", folder.path()},
                                       {"ANTEROOM_CACHE", "on"},
                                       {"ANTEROOM_CACHE_DIR", folder.path()}};
  const std::vector<Implementation> all = implementations(options, caches);
  std::vector<BenchRow> rows;
  for (const room::DemoEntry* entry : chosenDemos(demos, options.demo)) {
    fmt::print(stderr, "{}\n", entry->name);
    std::vector<Measured> measured(all.size());
    for (int round = 0; round < options.rounds; ++round) {
      for (std::size_t turn = 0; turn < all.size(); ++turn) {
        const std::size_t i = (turn + static_cast<std::size_t>(round)) % all.size();
        addRound(measured[i], options, entry->name, all[i]);
      }
    }
    const std::size_t first = rows.size();
    for (std::size_t i = 0; i < all.size(); ++i) rows.push_back(rowOf(entry->name, all[i].name, measured[i]));
    addRatios(rows, first);
    if (!options.withoutError) addErrors(rows, entry->name, options, all, folder.path(), caches);
  }
  return rows;
}

}  // namespace program
