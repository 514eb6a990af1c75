// Where pictures of frames go.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "options.h"
#include "room/picture.h"

namespace program {

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
  void finish();

 private:
  std::filesystem::path folder_;
  std::string format_;
  std::string stem_;
  FrameRange range_;
  std::unique_ptr<room::GifWriter> gif_;
  std::unique_ptr<room::ContactSheet> sheet_;
};

}  // namespace program
