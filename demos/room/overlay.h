// Lines of text over a finished picture.
#pragma once

#include <GLES/gl.h>

#include <string>
#include <string_view>
#include <vector>

#include "demo.h"
#include "texture.h"

namespace room {

class Overlay {
 public:
  Overlay();
  // In the upper left corner, letters 1/56 of the view's height, on a ground that takes `darkness` [0,1] of
  // what is below. Leaves identity matrices, depth test and culling off, texture unit 0 active and enabled.
  void draw(const View& view, const std::vector<std::string>& lines, double darkness = 0.5);
  // One line whose first letter's lower left corner is at a point; height: the letters'. Both in pixels of
  // the view, from its lower left corner. Leaves the same.
  void label(const View& view, glm::dvec2 at, double height, std::string_view text);

 private:
  void addQuad(glm::dvec2 low, glm::dvec2 high, glm::dvec2 uvLow, glm::dvec2 uvHigh);
  void addLine(glm::dvec2 at, double unit, std::string_view text);
  void begin(const View& view) const;
  void drawLetters(std::size_t first) const;

  Texture font_;
  std::vector<glm::vec2> positions_;
  std::vector<glm::vec2> texCoords_;
};

}  // namespace room
