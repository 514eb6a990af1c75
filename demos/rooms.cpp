// The Rooms demos: `rooms NAME` renders one of them to picture files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "lighting/lighting.h"
#include "particles/particles.h"
#include "postprocessing/postprocessing.h"
#include "reflect/reflect.h"
#include "room/context.h"
#include "room/demo.h"
#include "room/picture.h"
#include "room/progress.h"
#include "water/water.h"

namespace {

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
      {"water", "pool in an atrium: waves that refract and reflect, puddles that mirror the room",
       water::makeWater},
  };
  return entries;
}

struct Options {
  std::string demo;
  bool list = false;
  std::string size = "640x480";
  double time = 0;
  std::string frames = "1";
  double fps = 30;
  std::string stage;
  std::string out = ".";
  std::string format = "png";
  int samples = 4;
  int supersample = 1;
  room::Settings settings;
};

// Something the user can put right: the message alone is shown, and the exit status is 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Size {
  int width;
  int height;
};

struct FrameRange {
  int first;
  int last;
  bool numbered;  // whether the pictures' names hold the frame's number
};

// Two numbers with one character between them; nothing else in the text.
bool parsePair(const std::string& text, char between, int& a, int& b) {
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != between) return false;
  const auto second = std::from_chars(first.ptr + 1, end, b);
  return second.ec == std::errc() && second.ptr == end;
}

Size parseSize(const std::string& text) {
  Size size{};
  if (!parsePair(text, 'x', size.width, size.height) || size.width < 1 || size.height < 1 ||
      size.width > 16384 || size.height > 16384) {
    throw UsageError(fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, as in 640x480", text));
  }
  return size;
}

// "60" is the first sixty frames, "30-59" the second half of them.
FrameRange parseFrames(const std::string& text) {
  constexpr int kMost = 10'000'000;
  FrameRange range{};
  if (parsePair(text, '-', range.first, range.last)) {
    if (range.first >= 0 && range.last >= range.first && range.last < kMost)
      return {range.first, range.last, true};
  } else {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), range.last);
    const bool whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
    if (whole && range.last > 0 && range.last <= kMost) return {0, range.last - 1, range.last > 1};
  }
  throw UsageError(fmt::format("--frames {}: expected a count, as in 60, or a range, as in 30-59", text));
}

std::vector<std::string_view> demoNames() {
  std::vector<std::string_view> names;
  for (const room::DemoEntry& entry : demos()) names.push_back(entry.name);
  return names;
}

std::vector<const room::DemoEntry*> chosenDemos(const std::string& name) {
  std::vector<const room::DemoEntry*> chosen;
  for (const room::DemoEntry& entry : demos()) {
    if (name == "all" || name == entry.name) chosen.push_back(&entry);
  }
  if (chosen.empty()) {
    throw UsageError(name.empty()
                         ? fmt::format("which demo? There are: {}, or all", fmt::join(demoNames(), ", "))
                         : fmt::format("there is no demo '{}'; there are: {}, or all", name,
                                       fmt::join(demoNames(), ", ")));
  }
  return chosen;
}

std::vector<std::string_view> chosenStages(const room::Demo& demo, std::string_view name,
                                           const std::string& stage) {
  const auto known = demo.stages();
  if (stage.empty()) return {known.back()};
  if (stage == "all") return {known.begin(), known.end()};
  if (const auto found = std::find(known.begin(), known.end(), stage); found != known.end()) return {*found};
  throw UsageError(
      fmt::format("{} has no stage '{}'; its stages are: {}, or all", name, stage, fmt::join(known, ", ")));
}

// Draws the frames of one stage to files.
void renderStage(room::Demo& demo, const room::Context& context, const std::string& stem,
                 std::string_view stage, const Options& options) {
  const FrameRange range = parseFrames(options.frames);
  const std::filesystem::path folder = options.out;
  std::unique_ptr<room::GifWriter> gif;
  if (options.format == "gif") gif = std::make_unique<room::GifWriter>(folder / (stem + ".gif"), options.fps);
  room::Progress progress(stem, range.last - range.first + 1);
  for (int frame = range.first; frame <= range.last; ++frame) {
    const room::View view{context.width(), context.height(), options.time + frame / options.fps};
    demo.frame(view, stage);
    const room::Picture full = room::readPicture(view.width, view.height);
    const room::Picture picture = room::reducePicture(full, options.supersample);
    room::checkErrors(fmt::format("frame {} of {}", frame, stem));
    if (gif) {
      gif->add(picture);
    } else {
      const std::string name = range.numbered ? fmt::format("{}-{:04}", stem, frame) : stem;
      room::writePicture(folder / (name + "." + options.format), picture);
    }
    progress.advance();
  }
  if (gif) gif->close();
}

void render(const room::DemoEntry& entry, const Options& options) {
  const Size size = parseSize(options.size);
  if (!std::isfinite(options.time + parseFrames(options.frames).last / options.fps)) {
    throw UsageError("--time and --fps must give every frame a finite time");
  }
  const std::vector<std::string_view> stages = chosenStages(*entry.make(), entry.name, options.stage);
  std::filesystem::create_directories(options.out);

  const int fine = options.supersample;
  const room::Context context(size.width * fine, size.height * fine, options.samples);
  const std::unique_ptr<room::Demo> demo = entry.make();  // after the context, so that it goes before it
  demo->configure(options.settings);
  demo->setup();
  room::checkErrors(fmt::format("the setup of {}", entry.name));
  for (std::string_view stage : stages) {
    const bool finished = stage == demo->stages().back();
    const std::string stem = finished ? std::string(entry.name) : fmt::format("{}-{}", entry.name, stage);
    renderStage(*demo, context, stem, stage, options);
  }
}

void list() {
  for (const room::DemoEntry& entry : demos()) {
    fmt::print("{:<14} {}\n{:<14} stages: {}\n", entry.name, entry.summary, "",
               fmt::join(entry.make()->stages(), ", "));
  }
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Renders the Rooms demos with OpenGL ES 1.1.", "rooms");
  // A later option overrides an earlier one, so that scripts can have defaults.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_option("demo", options.demo, fmt::format("{}, or all", fmt::join(demoNames(), ", ")));
  app.add_flag("--list", options.list, "say which demos and stages there are");
  app.add_option("--size", options.size, "picture size in pixels")->capture_default_str();
  app.add_option("--time", options.time, "seconds at frame 0")->capture_default_str();
  app.add_option("--frames", options.frames, "how many frames, or which: 60 or 30-59")->capture_default_str();
  app.add_option("--fps", options.fps, "frames a second")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--stage", options.stage, "show one step of the demo, or all of them (see --list)");
  app.add_option("--out", options.out, "folder for the pictures")->capture_default_str();
  app.add_option("--format", options.format, "png, exr (linear light) or gif (one animation)")
      ->capture_default_str()
      ->check(CLI::IsMember({"png", "exr", "gif"}));
  app.add_option("--samples", options.samples, "multisamples a pixel, if the implementation has them")
      ->capture_default_str()
      ->check(CLI::Range(0, 16));
  app.add_option("--supersample", options.supersample, "render this many times larger and average")
      ->capture_default_str()
      ->check(CLI::Range(1, 4));
  app.add_option("--particles", options.settings.particles, "particles: how many particles the fire has")
      ->capture_default_str()
      ->check(CLI::Range(0, 1'000'000));
  app.add_flag("--quads", options.settings.quads, "particles: screen-aligned quads instead of point sprites");
  app.failure_message(CLI::FailureMessage::help);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  if (options.list) {
    list();
    return 0;
  }
  for (const room::DemoEntry* entry : chosenDemos(options.demo)) {
    try {
      render(*entry, options);
    } catch (const room::MissingExtension& missing) {
      if (options.demo != "all") throw;
      fmt::print(stderr, "rooms: {}: left out\n", missing.what());
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "rooms: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "rooms: {}\n", error.what());
    return 1;
  }
}
