#include "render.h"

#include <GLES/gl.h>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "counters.h"
#include "frame_files.h"
#include "room/context.h"
#include "room/picture.h"
#include "room/progress.h"

namespace program {
namespace {

using Clock = std::chrono::steady_clock;

// What the program has asked for and what the implementation has done, from one moment on.
class Meter {
 public:
  explicit Meter(const room::Context& context)
      : context_(context), asked_(counted()), done_(context.counters()) {}

  void print(const std::string& what, double frames, double milliseconds) const {
    const Counters c = counted() - asked_;
    const auto each = [frames](std::uint64_t count) { return static_cast<double>(count) / frames; };
    fmt::print("{:<24} {:9.2f} {:8.1f} {:10.0f} {:7.1f} {:9.1f} {:8.1f} {:9.1f}", what, milliseconds / frames,
               each(c.draws), each(c.vertices), each(c.clears), each(c.textureBinds), each(c.uploads),
               each(c.uploadedBytes) / 1024);
    const std::optional<room::ImplementationCounters> now = context_.counters();
    if (now && done_) {
      const room::ImplementationCounters d = *now - *done_;
      fmt::print(" | {:8.1f} {:10.2f} {:9.2f} {:9.1f}", each(d.draws), each(d.pipelines), each(d.compiles),
                 each(d.uploadedBytes) / 1024);
    }
    fmt::print("\n");
  }

  void printHeading() const {
    fmt::print("{:<24} {:>9} {:>8} {:>10} {:>7} {:>9} {:>8} {:>9}", "a frame, as it is asked", "ms", "draws",
               "vertices", "clears", "tex.binds", "uploads", "KiB");
    fmt::print("{}\n", done_ ? fmt::format(" | {:>8} {:>10} {:>9} {:>9}", "draws", "pipelines", "compiles",
                                           "KiB of tex.")
                             : " | the implementation does not tell what it does");
  }

 private:
  const room::Context& context_;
  Counters asked_;
  std::optional<room::ImplementationCounters> done_;
};

// Draws the frames of one stage to files.
void renderStage(room::Demo& demo, const room::Context& context, const std::string& stem,
                 std::string_view stage, const Options& options) {
  const FrameRange range = parseFrames(options.frames);
  FrameFiles output(options, stem);
  std::optional<room::Progress> progress(std::in_place, stem, range.count());
  const Meter meter(context);
  Clock::duration drawing{};
  for (int frame = range.first; frame <= range.last; ++frame) {
    const room::View view{context.width(), context.height(), timeOf(options, frame)};
    const auto begin = Clock::now();
    demo.frame(view, stage);
    if (options.stats) glFinish();
    drawing += Clock::now() - begin;
    const room::Picture full = room::readPicture(view.width, view.height);
    room::checkErrors(fmt::format("frame {} of {}", frame, stem));
    output.add(frame, room::reducePicture(full, options.supersample));
    progress->advance();
  }
  progress.reset();  // before anything else is written to the terminal
  output.finish();
  if (options.stats) {
    meter.print(stem, range.count(), std::chrono::duration<double, std::milli>(drawing).count());
  }
}

}  // namespace

void render(const room::DemoEntry& entry, const Options& options) {
  const Size size = parseSize(options.size);
  checkFrames(options);
  const std::vector<std::string_view> stages = chosenStages(*entry.make(), entry.name, options.stage);
  makeFolder(options.out);

  const int fine = options.supersample;
  const room::Context context(size.width * fine, size.height * fine, options.samples);
  const std::unique_ptr<room::Demo> demo = entry.make();  // after the context, so that it goes before it
  demo->configure(options.settings);
  const Meter meter(context);
  const auto begin = Clock::now();
  {
    const room::Progress progress(fmt::format("{}, set-up", entry.name), 1);
    demo->setup();
  }
  room::checkErrors(fmt::format("the setup of {}", entry.name));
  if (options.stats) {
    meter.printHeading();
    meter.print(fmt::format("{}, setup", entry.name), 1,
                std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  for (std::string_view stage : stages) {
    renderStage(*demo, context, stemOf(entry, *demo, stage), stage, options);
  }
}

}  // namespace program
