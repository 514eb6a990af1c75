// Lines of text over a finished picture.
#pragma once

#include <GLES/gl.h>

#include <string>
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

 private:
  void addQuad(glm::dvec2 low, glm::dvec2 high, glm::dvec2 uvLow, glm::dvec2 uvHigh);

  Texture font_;
  std::vector<glm::vec2> positions_;
  std::vector<glm::vec2> texCoords_;
};

}  // namespace room
