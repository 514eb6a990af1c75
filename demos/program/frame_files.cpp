#include "frame_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace program {

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && access(folder.c_str(), W_OK) != 0) error = {errno, std::generic_category()};
  if (error) {
    throw UsageError(fmt::format("no pictures can be written to '{}': {}", folder.string(), error.message()));
  }
}

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
    first_ = folder_ / (stem_ + ".gif");
    gif_ = std::make_unique<room::GifWriter>(first_, options.fps);
  }
}

void FrameFiles::add(int frame, const room::Picture& picture) {
  if (sheet_) {
    sheet_->add(picture);
  } else if (gif_) {
    gif_->add(picture);
  } else {
    const std::string name = range_.numbered ? fmt::format("{}-{:04}", stem_, frame) : stem_;
    write(folder_ / (name + "." + format_), picture);
  }
}

void FrameFiles::write(const std::filesystem::path& file, const room::Picture& picture) {
  room::writePicture(file, picture);
  last_ = file;
  if (first_.empty()) first_ = file;
}

void FrameFiles::finish() {
  if (sheet_) write(folder_ / (stem_ + "-sheet." + format_), sheet_->picture());
  if (gif_) gif_->close();
  if (first_.empty()) return;
  if (last_.empty() || last_ == first_) {
    fmt::print("wrote {}\n", first_.string());
  } else {
    fmt::print("wrote {} to {}\n", first_.string(), last_.filename().string());
  }
  std::fflush(stdout);
}

}  // namespace program
