// What the cache saves, and what it costs: `anteroom-cache-speed`. The demos are measured in fresh processes:
// without what they left, and with it.
#include <GLES/gl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
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
#include "tests/measure/options.h"
#include "tests/measure/statistics.h"
#include "water/water.h"

namespace {

using namespace anteroom;
using Clock = std::chrono::steady_clock;

constexpr int kFrames = 60;
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

// One run of a demo, a number a round.
struct Run {
  std::vector<double> first, median, worst;  // ms a frame; worst of all but the first
  std::vector<double> compiled, creating;    // calls into glslang; ms that the driver took to make pipelines
  std::string fault;
};
constexpr int kRuns = 3;

// A demo that begins with empty caches, and again with what was left.
void addRound(const std::string& demo, std::array<Run, kRuns>& runs) {
  const process::TemporaryDirectory folder;
  const process::Environment environment = measure::withCaches({}, folder.path());
  const std::filesystem::path file = environment.at("ANTEROOM_CACHE_DIR") + "/anteroom.db";
  for (Run& run : runs) {
    const int64_t before = shadersIn(file);
    const process::Outcome outcome = process::run("/proc/self/exe", {"--demo", demo}, environment);
    const auto json = nlohmann::json::parse(outcome.output, nullptr, false);
    if (outcome.status != 0 || !json.is_array() || json.size() != kFrames) {
      run.fault = fmt::format("ended with status {}", outcome.status);
      return;
    }
    const auto times = json.get<std::vector<double>>();
    run.first.push_back(times[0]);
    run.median.push_back(measure::median({times.begin() + 1, times.end()}));
    run.worst.push_back(*std::max_element(times.begin() + 1, times.end()));
    run.compiled.push_back(static_cast<double>(shadersIn(file) - before));
    run.creating.push_back(creatingMilliseconds(file));
  }
}

measure::Table demoTable(const std::vector<std::string>& demos, int rounds) {
  std::vector<std::array<Run, kRuns>> all(demos.size());
  for (int round = 0; round < rounds; ++round)
    measure::takeTurns(static_cast<std::size_t>(round), demos.size(),
                       [&](std::size_t i) { addRound(demos[i], all[i]); });
  measure::Table table({{"demo"},
                        {"run"},
                        {"first frame", "ms", 2},
                        {"spread", "%"},
                        {"median frame", "ms", 2},
                        {"first to median", "", 2},
                        {"worst to median", "", 2},
                        {"glslang calls"},
                        {"pipelines", "ms", 2},
                        {"fault"}});
  for (std::size_t i = 0; i < demos.size(); ++i) {
    for (std::size_t number = 0; number < kRuns; ++number) {
      const Run& run = all[i][number];
      std::vector<measure::Cell> row = {demos[i], static_cast<double>(number + 1)};
      if (run.fault.empty() && !run.first.empty())
        row.insert(row.end(), {measure::median(run.first), 100 * measure::summary(run.first).spread(),
                               measure::median(run.median), measure::ratio(run.first, run.median).median,
                               measure::ratio(run.worst, run.median).median, measure::median(run.compiled),
                               measure::median(run.creating)});
      row.resize(9);
      row.push_back(run.fault);
      table.add(std::move(row));
    }
  }
  return table;
}

std::string keyOf(int row) {
  return fmt::format("#version 450\n// {}\n", row);
}

std::vector<uint32_t> spirvOf(int row) {
  std::vector<uint32_t> spirv{0x07230203, 0x00010300, 0, 10, 0, 0x00030003, 2, static_cast<uint32_t>(row)};
  spirv.resize(700, 0x00010000);
  return spirv;
}

measure::Table fileTable() {
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
  measure::Table table({{"rows"}, {"opening", "ms", 2}, {"finding a shader", "us", 1}});
  table.add({static_cast<double>(kRows), measure::median(opening), measure::median(finding)});
  return table;
}

// The first use of state mixes beside Mesa's. Returns only when there is no such program.
void becomeBench() {
  fmt::print(
      "\nfirst use of state mixes, with both caches (anteroom-bench --compare --filter first_use.warm):\n");
  std::fflush(stdout);
  const std::string bench = process::executableDirectory() + "/anteroom-bench";
  execl(bench.c_str(), bench.c_str(), "--compare", "--filter", "first_use.warm", "--rounds", "5",
        static_cast<char*>(nullptr));
  throw std::runtime_error(bench + " is not there");
}

void report(const std::vector<std::string>& demos, int rounds, measure::Format format) {
  const measure::Table file = fileTable(), frames = demoTable(demos, rounds);
  if (format == measure::Format::Json) {
    fmt::print("{}\n", nlohmann::json{{"file", file.json()}, {"demos", frames.json()}}.dump(2));
  } else if (format == measure::Format::Csv) {
    fmt::print("{}\n{}", file.csv(), frames.csv());
  } else {
    fmt::print("{}\n{}", file.text(), frames.text());
    becomeBench();
  }
}

}  // namespace

int main(int argc, char** argv) {
  measure::Filter filter;
  measure::Format format = measure::Format::Text;
  int rounds = 1;
  std::string demo;
  CLI::App app("What the cache saves, and what it costs.");
  app.set_version_flag("--version", "anteroom-cache-speed " ANTEROOM_VERSION);
  measure::addFilter(app, filter);
  measure::addRounds(app, rounds);
  measure::addFormat(app, format);
  app.add_option("--demo", demo)->group("");
  try {
    app.parse(argc, argv);
    if (!demo.empty()) {
      drawDemo(demo);
      return 0;
    }
    std::vector<std::string> names;
    for (const room::DemoEntry& entry : kDemos) names.emplace_back(entry.name);
    report(filter.chosen(names), rounds, format);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 2 : 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-cache-speed: {}\n", error.what());
    return measure::kUsage;
  }
}
