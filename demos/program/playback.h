// What keys change while a demo runs; knows of no window.
#pragma once

#include <span>
#include <string_view>

#include "room/demo.h"

namespace program {

enum class Action {
  Pause,
  StepForward,
  StepBack,
  NextStage,
  PreviousStage,
  TurnLeft,
  TurnRight,
  Nearer,
  Farther,
  ResetCamera,
  SavePicture,
  Help,
  Quit
};

class Playback {
 public:
  // stage is one of the stages; time and frame, what a step takes, in seconds.
  Playback(std::span<const std::string_view> stages, std::string_view stage, double time, double frame);

  void handle(Action action);
  // So many seconds have gone by; nothing happens while paused.
  void advance(double seconds);

  room::View view(int width, int height) const { return {width, height, time_, yaw_, zoom_}; }
  std::string_view stage() const { return stages_[stage_]; }
  double time() const { return time_; }
  bool paused() const { return paused_; }
  bool helps() const { return helps_; }
  bool quits() const { return quits_; }
  // Whether a picture has been asked for since the last call.
  bool takePictureRequest();

 private:
  std::span<const std::string_view> stages_;
  std::size_t stage_;
  double time_;
  double frame_;
  double yaw_ = 0;
  double zoom_ = 1;
  bool paused_ = false;
  bool helps_ = false;
  bool quits_ = false;
  bool pictureRequested_ = false;
};

}  // namespace program
