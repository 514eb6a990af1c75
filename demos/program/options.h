// What the command line of `rooms` says.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "room/demo.h"

namespace program {

// Something the user can put right: the message alone is shown, and the exit status is 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::string demo;
  std::string size = "640x480";
  double time = 0;
  std::string frames = "1";
  double fps = 30;
  std::string stage;
  std::string out = ".";
  std::string format = "png";
  int samples = 4;
  int supersample = 1;
  bool contactSheet = false;
  bool stats = false;
  bool window = false;
  bool framesChosen = false;  // a window without shows all that come, in real time
  room::Settings settings;
};

struct Size {
  int width;
  int height;
};
Size parseSize(const std::string& text);

struct FrameRange {
  int first;
  int last;
  bool numbered;  // whether the pictures' names hold the frame's number

  int count() const { return last - first + 1; }
};
// "60" is the first sixty frames, "30-59" the second half of them.
FrameRange parseFrames(const std::string& text);

// The demos by that name, or all of them.
std::vector<const room::DemoEntry*> chosenDemos(const std::vector<room::DemoEntry>& demos,
                                                const std::string& name);
// The finished picture where no stage is named, or all of them.
std::vector<std::string_view> chosenStages(const room::Demo& demo, std::string_view name,
                                           const std::string& stage);

}  // namespace program
