// ANTEROOM_HUD: numbers over the picture that a surface shows.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "layer/render/hud.h"
#include "layer/render/renderer.h"

namespace anteroom::egl {

enum class HudItem : uint8_t {
  Fps,
  Frame,
  Draws,
  Passes,
  Submits,
  Pipelines,
  Compiles,
  Cache,
  Memory,
  Uploads
};

struct HudOptions {
  std::vector<HudItem> items;  // from top to bottom; empty: no HUD
  bool pbuffers = false;       // over the pictures of pbuffers, too
};

// Words, separated by commas; `1`: the usual ones, `all`. `complaint`: lines for stderr about unknown words,
// or the list that `help` asks for; else empty.
HudOptions parseHudOptions(std::string_view words, std::string& complaint);

// What ANTEROOM_HUD says when this process asks first. Thread-safe.
const HudOptions& hudOptions();

// The HUD of one surface. Frames make no allocation.
class Hud {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Hud(const HudOptions& options);

  // A frame has been drawn by a context whose statistics are these. What to show is in picture().
  void frame(const render::Stats& stats, const void* context, Clock::time_point now);
  const render::Hud& picture() const { return picture_; }

 private:
  void noteTime(float milliseconds);
  void write(const render::Stats& stats, double seconds);
  void writeLine(size_t index, const render::Stats& stats, double seconds);

  const std::vector<HudItem> items_;
  render::Hud picture_;
  std::array<float, render::Hud::kSamples> times_{};  // ms, the oldest first
  const void* context_ = nullptr;
  render::Stats base_;  // at the start of the interval that the numbers are of
  Clock::time_point start_, last_;
  int frames_ = 0;  // in the interval
  bool written_ = false;
};

// Null: none is wanted for such a surface.
std::unique_ptr<Hud> createHud(bool window);

}  // namespace anteroom::egl
