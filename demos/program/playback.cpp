#include "playback.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

namespace program {
namespace {

constexpr double kZoomStep = 1.05;
constexpr double kNearest = 0.3;
constexpr double kFarthest = 1.5;

}  // namespace

Playback::Playback(std::span<const std::string_view> stages, std::string_view stage, double time,
                   double frame)
    : stages_(stages),
      stage_(static_cast<std::size_t>(std::find(stages.begin(), stages.end(), stage) - stages.begin())),
      time_(time),
      frame_(frame) {}

void Playback::handle(Action action) {
  static const double kTurn = glm::radians(3.0);
  switch (action) {
    case Action::Pause:
      paused_ = !paused_;
      break;
    case Action::StepForward:
      paused_ = true;
      time_ += frame_;
      break;
    case Action::StepBack:
      paused_ = true;
      time_ -= frame_;
      break;
    case Action::NextStage:
      stage_ = (stage_ + 1) % stages_.size();
      break;
    case Action::PreviousStage:
      stage_ = (stage_ + stages_.size() - 1) % stages_.size();
      break;
    case Action::TurnLeft:
      yaw_ -= kTurn;
      break;
    case Action::TurnRight:
      yaw_ += kTurn;
      break;
    case Action::Nearer:
      zoom_ = std::max(zoom_ / kZoomStep, kNearest);
      break;
    case Action::Farther:
      zoom_ = std::min(zoom_ * kZoomStep, kFarthest);
      break;
    case Action::ResetCamera:
      yaw_ = 0;
      zoom_ = 1;
      break;
    case Action::SavePicture:
      pictureRequested_ = true;
      break;
    case Action::Help:
      helps_ = !helps_;
      break;
    case Action::Quit:
      quits_ = true;
      break;
  }
}

void Playback::advance(double seconds) {
  if (!paused_) time_ += seconds;
}

bool Playback::takePictureRequest() {
  return std::exchange(pictureRequested_, false);
}

}  // namespace program
