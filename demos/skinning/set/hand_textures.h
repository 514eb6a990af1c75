// What the hand is painted with, and what shines on it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "room/image.h"

namespace skinning {

// Glazed porcelain with the lines and signs of palmistry. RGB the color, A the gloss.
room::Image handBase();

// A light as a mirror sees it: a soft disc in a direction.
struct Highlight {
  glm::dvec3 direction;  // a unit vector
  double radius;         // radians
  double strength;
};
// A window of four panes, a corner and two edges as seen from the hand.
struct BrightWindow {
  glm::dvec3 corner, across, up;
  double strength;
};

// What a glossy body reflects of the room, as alpha (and as luminance): six faces of a cube map.
std::array<room::Image, 6> highlightFaces(const std::vector<Highlight>& lights, const BrightWindow& window);

}  // namespace skinning
