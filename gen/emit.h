// What both emitters share: the text of a shader in the making, and the interface between the stages.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gen/key.h"

namespace anteroom::gen {

// Locations of what the vertex stage hands to the fragment stage.
inline constexpr int kFrontColorLocation = 0;
inline constexpr int kBackColorLocation = 1;
inline constexpr int kFogDepthLocation = 2;
inline constexpr int kDiameterLocation = 3;
inline constexpr int kClipLocation = 4;  // two: four distances each
inline constexpr int kTexCoordLocation = 6;
inline constexpr int kFadeLocation = kTexCoordLocation + kMaxTextureUnits;

// "vec2" for St and so on: the type between the stages.
std::string_view coordinateType(Coordinate coordinate);

// Collects a shader's parts. call("safeNormalize") brings in the snippet of that name and those it expects.
class Shader {
 public:
  explicit Shader(std::string description) : description_(std::move(description)) {}

  void declare(std::string_view text) { declarations_ += text; }
  template <class... Args>
  void declareLine(fmt::format_string<Args...> format, Args&&... args) {
    declarations_ += fmt::format(format, std::forward<Args>(args)...) + '\n';
  }
  void define(std::string_view text) { functions_ += text; }
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    body_ += "  " + fmt::format(format, std::forward<Args>(args)...) + '\n';
  }
  std::string_view call(std::string_view function);

  std::string text() const;

 private:
  std::string description_, declarations_, functions_, body_;
  std::vector<std::string_view> called_;  // in an order that declares before use
};

}  // namespace anteroom::gen
