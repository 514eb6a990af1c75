// What ANTEROOM_HUD shows, as a renderer draws it: lines of text on a plate in the upper left corner, one
// perhaps with a graph below it.
#pragma once

#include <array>

namespace anteroom::render {

struct Hud {
  static constexpr int kColumns = 24;  // characters of a line
  static constexpr int kMostLines = 12;
  static constexpr int kSamples = 6 * kColumns;  // of the graph: a pixel each

  using Line = std::array<char, kColumns>;  // ASCII, with spaces after its end

  int lines = 0;
  int nameColumns = 0;  // how many of each line hold a name; the rest is a value
  std::array<Line, kMostLines> text{};
  int graphLine = -1;                   // the line that the graph is below; -1: there is none
  std::array<float, kSamples> graph{};  // the oldest first, from 0 to 1
  float graphMark = 0;                  // where the graph has a line across, from 0 to 1
};

}  // namespace anteroom::render
