// The Rooms demos: `rooms NAME` renders one of them to picture files or shows it in a window, `rooms bench`
// measures them, `rooms study water` measures the integrators of the Water demo's springs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "lighting/lighting.h"
#include "particles/particles.h"
#include "postprocessing/postprocessing.h"
#include "program/bench.h"
#include "program/frame_files.h"
#include "program/options.h"
#include "program/render.h"
#include "program/window.h"
#include "reflect/reflect.h"
#include "room/context.h"
#include "room/picture.h"
#include "skinning/skinning.h"
#include "water/study.h"
#include "water/water.h"

namespace {

using program::BenchOptions;
using program::Options;
using program::UsageError;
using program::WorkerTask;

constexpr int kWrongUsage = 2;  // exit status

const std::vector<room::DemoEntry>& demos() {
  static const std::vector<room::DemoEntry> entries = {
      {"lighting", "bump-mapped room, trash can with highlights, two moving spotlights and their shadows",
       lighting::makeLighting},
      {"particles", "brazier in a cellar: a fire of point sprites, and lightmaps that flicker with it",
       particles::makeParticles},
      {"postprocessing", "chapel whose bright windows bloom around what stands before them",
       postprocessing::makePostprocessing},
      {"reflect", "shining ball in a playroom, a train around it, and a cube map made anew every frame",
       reflect::makeReflect},
      {"skinning", "fortune-teller's parlour: a porcelain hand of 20 bones waves, makes a fist and points",
       skinning::makeSkinning},
      {"water", "pool in an atrium: waves that refract and reflect, puddles that mirror the room",
       water::makeWater},
  };
  return entries;
}

std::vector<std::string_view> demoNames() {
  std::vector<std::string_view> names;
  for (const room::DemoEntry& entry : demos()) names.push_back(entry.name);
  return names;
}

void list() {
  for (const room::DemoEntry& entry : demos()) {
    fmt::print("{:<14} {}\n{:<14} stages: {}\n", entry.name, entry.summary, "",
               fmt::join(entry.make()->stages(), ", "));
  }
}

void describeSettings(CLI::App& app, room::Settings& settings) {
  app.add_option("--particles", settings.particles, "particles: how many particles the fire has")
      ->capture_default_str()
      ->check(CLI::Range(0, 1'000'000));
  app.add_flag("--quads", settings.quads, "particles: screen-aligned quads instead of point sprites");
  app.add_flag("--culled", settings.culled,
               "reflect: tell over the picture how many things each face leaves out");
  app.add_option(
         "--skin", settings.skin,
         "skinning: by the GL's matrix palette, by the program, or any: by the palette where there is one")
      ->capture_default_str()
      ->check(CLI::IsMember({"palette", "cpu", "any"}));
  app.add_option("--water", settings.water,
                 "water: sums of waves, or springs: a sheet of masses that drops fall on")
      ->capture_default_str()
      ->check(CLI::IsMember({"waves", "springs"}));
  app.add_option("--integrator", settings.integrator, "water: what moves the springs")
      ->capture_default_str()
      ->check(CLI::IsMember({"explicit", "semi-implicit", "implicit"}));
  app.add_option("--stiffness", settings.stiffness, "water: of the springs, over a mass, 1/s^2")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
}

void describeSamples(CLI::App& app, int& samples) {
  app.add_option("--samples", samples, "multisamples a pixel, if the implementation has them")
      ->capture_default_str()
      ->check(CLI::Range(0, 16));
}

void describeRendering(CLI::App& app, Options& options) {
  app.add_option("demo", options.demo, fmt::format("{}, or all", fmt::join(demoNames(), ", ")));
  app.add_flag_callback(
      "--list",
      [] {
        list();
        throw CLI::Success();
      },
      "say which demos and stages there are");
  app.add_option("--size", options.size, "picture size in pixels")->capture_default_str();
  app.add_option("--time", options.time, "seconds at frame 0")->capture_default_str();
  app.add_option("--frames", options.frames, "how many frames, or which: 60 or 30-59")->capture_default_str();
  app.add_option("--fps", options.fps, "frames a second")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--stage", options.stage, "show one step of the demo, or all of them (see --list)");
  app.add_option("--out", options.out, "folder for the pictures")->capture_default_str();
  app.add_option("--format", options.format, "png, exr (linear light) or gif (one animation)")
      ->capture_default_str()
      ->check(CLI::IsMember({"png", "exr", "gif"}));
  app.add_flag("--contact-sheet", options.contactSheet, "all frames side by side in one picture");
  CLI::Option* stats =
      app.add_flag("--stats", options.stats,
                   "print what a frame takes: draws, uploads and so on that the program counts, and time");
  describeSamples(app, options.samples);
  CLI::Option* supersample =
      app.add_option("--supersample", options.supersample, "render this many times larger and average")
          ->capture_default_str()
          ->check(CLI::Range(1, 4));
  app.add_flag("--window", options.window,
               "show the demo in a window, in real time; H shows what the keys do. With --frames just those, "
               "which go to files, too")
      ->excludes(stats)
      ->excludes(supersample);
  describeSettings(app, options.settings);
}

void describeBench(CLI::App& app, BenchOptions& options, std::string& worker) {
  app.add_option("demo", options.demo, "a demo's name, or all")->capture_default_str();
  app.add_option("--size", options.size, "of the frames that are timed, in pixels")->capture_default_str();
  app.add_option("--error-size", options.errorSize, "of the pictures that are compared, in pixels")
      ->capture_default_str();
  app.add_option("--frames", options.frames, "how many frames a round")
      ->capture_default_str()
      ->check(CLI::Range(1, 1'000'000));
  measure::addFilter(app, options.filter);
  measure::addRounds(app, options.rounds);
  app.add_option("--time", options.time, "seconds at frame 0, and of the compared picture")
      ->capture_default_str();
  describeSamples(app, options.samples);
  app.add_flag("--found", options.found,
               "only the implementation that is found, instead of ours, Mesa's own and Mesa's zink");
  measure::addSources(app, options.sources);
  app.add_flag("--no-error", options.withoutError, "leave the reference renderer out");
  measure::addFormat(app, options.format);
  app.add_option("--worker", worker)->group("");
  describeSettings(app, options.settings);
}

int renderChosen(const Options& options) {
  if (options.window) {
    if (options.demo == "all") throw UsageError("--window shows one demo, not all of them");
    program::show(*program::chosenDemos(demos(), options.demo).front(), options);
    return 0;
  }
  for (const room::DemoEntry* entry : program::chosenDemos(demos(), options.demo)) {
    try {
      program::render(*entry, options);
    } catch (const room::MissingExtension& missing) {
      if (options.demo != "all") throw;
      fmt::print(stderr, "rooms: {}: left out\n", missing.what());
    }
  }
  return 0;
}

int benchChosen(const BenchOptions& options, const std::string& worker) {
  if (!worker.empty()) {
    return program::work(demos(), {options.demo, options.size, options.frames, options.samples, options.time,
                                   worker == "time" ? "" : worker, options.settings});
  }
  std::fputs(program::benchReport(program::bench(demos(), options), options.format).c_str(), stdout);
  return 0;
}

int study(const std::string& what, const std::string& out) {
  if (what != "water") throw UsageError(fmt::format("there is no study of '{}'; there is: water", what));
  const std::vector<water::StudyEntry> entries = water::studyIntegrators();
  std::fputs(water::studyTable(entries).c_str(), stdout);
  program::makeFolder(out);
  const std::filesystem::path file = std::filesystem::path(out) / "study-water.png";
  room::writePicture(file, room::drawPlot(water::plotOf(entries), 1200, 900));
  fmt::print("plotted in {}\n", file.string());
  return 0;
}

int run(int argc, char** argv) {
  Options options;
  BenchOptions benchOptions;
  std::string worker;
  std::string studied;
  std::string studyOut = ".";
  CLI::App app("Renders the Rooms demos with OpenGL ES 1.1.", "rooms");
  // A later option overrides an earlier one, so that scripts can have defaults.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.set_version_flag("--version", "rooms " ANTEROOM_VERSION);
  app.failure_message(CLI::FailureMessage::simple);
  describeRendering(app, options);
  CLI::App& benchApp =
      *app.add_subcommand("bench", "error beside run time, of ours and of Mesa's two in turns");
  describeBench(benchApp, benchOptions, worker);
  CLI::App& studyApp = *app.add_subcommand(
      "study", "water: error against run time of the springs' integrators, as a table and a plot");
  studyApp.add_option("what", studied, "water")->required();
  studyApp.add_option("--out", studyOut, "folder for the plot")->capture_default_str();
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongUsage;
  }
  if (benchApp.parsed()) return benchChosen(benchOptions, worker);
  if (studyApp.parsed()) return study(studied, studyOut);
  options.framesChosen = app.count("--frames") > 0;
  return renderChosen(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "rooms: {}\n", error.what());
    return kWrongUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "rooms: {}\n", error.what());
    return 1;
  }
}
