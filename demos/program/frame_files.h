// Where pictures of frames go.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "options.h"
#include "room/picture.h"

namespace program {

// With the folders above it. Throws UsageError where that cannot be, or nothing can be written there.
void makeFolder(const std::filesystem::path& folder);

// Seconds at which a frame is drawn.
double timeOf(const Options& options, double frame);

// What a stage's files are called: after the demo, and after the stage where it is not the finished one.
std::string stemOf(const room::DemoEntry& entry, const room::Demo& demo, std::string_view stage);

// Throws UsageError for frames without a finite time, and for more than a contact sheet should hold.
void checkFrames(const Options& options);

// The frames of one stage, each a file, or all of them one animation or one contact sheet.
class FrameFiles {
 public:
  FrameFiles(const Options& options, std::string stem);
  void add(int frame, const room::Picture& picture);
  // Completes the files and says on standard output which there are.
  void finish();

 private:
  void write(const std::filesystem::path& file, const room::Picture& picture);

  std::filesystem::path folder_;
  std::string format_;
  std::string stem_;
  FrameRange range_;
  std::filesystem::path first_, last_;  // that have been written
  std::unique_ptr<room::GifWriter> gif_;
  std::unique_ptr<room::ContactSheet> sheet_;
};

}  // namespace program
