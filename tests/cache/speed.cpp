// What the cache saves, and what it costs: `anteroom-cache-speed`. The demos are measured in fresh processes:
// without what they left, and with it.
#include <GLES/gl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "layer/cache/shader_cache.h"
#include "lighting/lighting.h"
#include "particles/particles.h"
#include "postprocessing/postprocessing.h"
#include "reflect/reflect.h"
#include "room/context.h"
#include "skinning/skinning.h"
#include "tests/measure/process.h"
#include "water/water.h"

namespace {

using namespace anteroom;
using Clock = std::chrono::steady_clock;

constexpr int kFrames = 60;
constexpr unsigned kSeconds = 300;
constexpr int kWidth = 640, kHeight = 480;

const room::DemoEntry kDemos[] = {{"lighting", "", lighting::makeLighting},
                                  {"particles", "", particles::makeParticles},
                                  {"postprocessing", "", postprocessing::makePostprocessing},
                                  {"reflect", "", reflect::makeReflect},
                                  {"skinning", "", skinning::makeSkinning},
                                  {"water", "", water::makeWater}};

double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// In a process of its own: the times of all frames.
void drawDemo(const std::string& name) {
  const auto entry =
      std::find_if(std::begin(kDemos), std::end(kDemos), [&](const auto& e) { return e.name == name; });
  const room::Context context(kWidth, kHeight, 4);
  const std::unique_ptr<room::Demo> demo = entry->make();
  demo->setup();
  glFinish();
  std::vector<double> times;
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto start = Clock::now();
    demo->frame({kWidth, kHeight, frame / 30.0}, demo->stages().back());
    glFinish();
    times.push_back(milliseconds(Clock::now() - start));
  }
  fmt::print("{}\n", nlohmann::json(times).dump());
}

// glslang was called once for each row that is new.
int64_t shadersIn(const std::filesystem::path& file) {
  cache::Store store;
  if (store.open(file, cache::Store::Mode::Read) != cache::Opened::Ok) return 0;
  return store.database().ask("SELECT count(*) FROM shader", 0);
}

double creatingMilliseconds(const std::filesystem::path& file) {
  cache::Store store;
  if (store.open(file, cache::Store::Mode::Read) != cache::Opened::Ok) return 0;
  return static_cast<double>(store.database().ask("SELECT total(create_us) FROM pipeline", 0)) / 1000;
}

void reportDemos(const std::string& program) {
  fmt::print("{:15} {:>3} {:>10} {:>10} {:>10} {:>10} {:>13} {:>15}\n", "demo", "run", "first ms",
             "median ms", "first/med.", "worst/med.", "glslang calls", "pipelines ms");
  for (const auto& demo : kDemos) {
    const process::TemporaryDirectory folder;
    const process::Environment environment{{"ANTEROOM_CACHE", "on"},
                                           {"ANTEROOM_CACHE_DIR", folder.path()},
                                           {"MESA_SHADER_CACHE_DIR", folder.path()},
                                           {"MESA_SHADER_CACHE_DISABLE", "false"}};
    const std::filesystem::path file = std::filesystem::path(folder.path()) / "anteroom.db";
    for (int run = 1; run <= 3; ++run) {
      const int64_t before = shadersIn(file);
      const process::Outcome outcome =
          process::run(program, {"--demo", std::string(demo.name)}, environment, kSeconds);
      const auto json = nlohmann::json::parse(outcome.output, nullptr, false);
      if (outcome.status != 0 || !json.is_array() || json.size() != kFrames) {
        fmt::print("{:15} {:>3} failed with status {}\n", demo.name, run, outcome.status);
        break;
      }
      const auto times = json.get<std::vector<double>>();
      const double middle = median({times.begin() + 1, times.end()});
      fmt::print("{:15} {:>3} {:10.2f} {:10.2f} {:10.2f} {:10.2f} {:>13} {:15.2f}\n", demo.name, run,
                 times[0], middle, times[0] / middle,
                 *std::max_element(times.begin() + 1, times.end()) / middle, shadersIn(file) - before,
                 creatingMilliseconds(file));
    }
  }
}

std::string keyOf(int row) {
  return fmt::format("#version 450\n// {}\n", row);
}

std::vector<uint32_t> spirvOf(int row) {
  std::vector<uint32_t> spirv{0x07230203, 0x00010300, 0, 10, 0, 0x00030003, 2, static_cast<uint32_t>(row)};
  spirv.resize(700, 0x00010000);
  return spirv;
}

void reportFile() {
  const process::TemporaryDirectory folder;
  const std::filesystem::path file = std::filesystem::path(folder.path()) / "anteroom.db";
  constexpr int kRows = 10000;
  {
    cache::Store store;
    bool good = store.open(file, cache::Store::Mode::Create) == cache::Opened::Ok && store.begin();
    for (int i = 0; i < kRows && good; ++i) {
      const std::string key = keyOf(i);
      good = store.put(
          cache::makeRow(cache::KeyKind::VertexText, std::as_bytes(std::span(key)), key, spirvOf(i), 1));
    }
    if (!good || !store.commit()) throw std::runtime_error("a cache cannot be written: " + store.message());
  }
  std::vector<double> opening, finding;
  for (int i = 0; i < 21; ++i) {
    const auto start = Clock::now();
    cache::ShaderCache cache(file, UINT64_MAX);
    if (!cache.filled()) throw std::runtime_error("a cache of 10,000 rows holds nothing");
    opening.push_back(milliseconds(Clock::now() - start));
  }
  cache::ShaderCache cache(file, UINT64_MAX);
  cache.filled();
  for (int i = 0; i < 2000; ++i) {
    const std::string key = keyOf(i * 7919 % kRows);
    const auto start = Clock::now();
    if (cache.find(cache::KeyKind::VertexText, std::as_bytes(std::span(key))).empty())
      throw std::runtime_error("a row is missing");
    finding.push_back(milliseconds(Clock::now() - start) * 1000);
  }
  fmt::print("a cache of {} rows: opened in {:.2f} ms, a shader found in {:.1f} us (medians)\n\n", kRows,
             median(opening), median(finding));
}

}  // namespace

int main(int argc, char** argv) {
  std::string demo;
  CLI::App app("Reports what the shader cache saves, and what it costs.");
  app.set_version_flag("--version", "anteroom-cache-speed " ANTEROOM_VERSION);
  app.add_option("--demo", demo)->group("");
  try {
    app.parse(argc, argv);
    if (!demo.empty()) {
      drawDemo(demo);
      return 0;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    reportFile();
    reportDemos("/proc/self/exe");
    fmt::print(
        "\nfirst use of state mixes, with both caches (anteroom-bench --compare --filter first_use.warm):\n");
    std::fflush(stdout);
    const std::string bench = process::executableDirectory() + "/anteroom-bench";
    execl(bench.c_str(), bench.c_str(), "--compare", "--filter", "first_use.warm", "--rounds", "5",
          static_cast<char*>(nullptr));
    fmt::print(stderr, "anteroom-cache-speed: {} is not there\n", bench);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 2 : 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-cache-speed: {}\n", error.what());
  }
  return 1;
}
