#include "frame_files.h"

#include <fmt/format.h>

#include <cmath>

namespace program {

double timeOf(const Options& options, double frame) {
  return options.time + frame / options.fps;
}

std::string stemOf(const room::DemoEntry& entry, const room::Demo& demo, std::string_view stage) {
  return stage == demo.stages().back() ? std::string(entry.name) : fmt::format("{}-{}", entry.name, stage);
}

void checkFrames(const Options& options) {
  if (!std::isfinite(timeOf(options, parseFrames(options.frames).last))) {
    throw UsageError("--time and --fps must give every frame a finite time");
  }
  if (!options.contactSheet) return;
  if (options.format == "gif") throw UsageError("--contact-sheet is one picture: --format png or exr");
  const Size size = parseSize(options.size);
  constexpr double kMostPixels = 1e8;
  if (static_cast<double>(size.width) * size.height * parseFrames(options.frames).count() > kMostPixels) {
    throw UsageError(
        "--contact-sheet: so many frames of that size are more than one picture should hold; "
        "choose a smaller --size or fewer --frames");
  }
}

FrameFiles::FrameFiles(const Options& options, std::string stem)
    : folder_(options.out),
      format_(options.format),
      stem_(std::move(stem)),
      range_(parseFrames(options.frames)) {
  if (options.contactSheet) {
    sheet_ = std::make_unique<room::ContactSheet>(range_.count());
  } else if (format_ == "gif") {
    gif_ = std::make_unique<room::GifWriter>(folder_ / (stem_ + ".gif"), options.fps);
  }
}

void FrameFiles::add(int frame, const room::Picture& picture) {
  if (sheet_) {
    sheet_->add(picture);
  } else if (gif_) {
    gif_->add(picture);
  } else {
    const std::string name = range_.numbered ? fmt::format("{}-{:04}", stem_, frame) : stem_;
    room::writePicture(folder_ / (name + "." + format_), picture);
  }
}

void FrameFiles::finish() {
  if (sheet_) room::writePicture(folder_ / (stem_ + "-sheet." + format_), sheet_->picture());
  if (gif_) gif_->close();
}

}  // namespace program
