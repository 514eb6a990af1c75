// The light that falls through the windows, worked out once for everything that stands still.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "room/image.h"
#include "stone_and_glass.h"

namespace postprocessing {

// An axis-aligned block that light does not pass.
struct Block {
  glm::dvec3 low;
  glm::dvec3 high;
};

struct GlazedLancet {
  Lancet lancet;
  room::Image glass;  // what it lets through, as it is displayed; row 0 at the sill
};

class Daylight {
 public:
  // glassPlane: z of the windows, which the rest of the room is in front of.
  Daylight(const std::vector<GlazedLancet>& windows, double glassPlane, glm::dvec3 toSun,
           std::vector<Block> blocks);

  // Linear light on a surface element; 1 is what makes white look white.
  glm::dvec3 diffuse(glm::dvec3 point, glm::dvec3 normal) const;
  glm::dvec3 sun(glm::dvec3 point, glm::dvec3 normal) const;

 private:
  struct Patch {
    glm::dvec3 center;
    glm::dvec3 color;  // linear, times its area
  };
  bool blocked(const glm::dvec3& from, const glm::dvec3& direction, double length) const;
  double openness(const glm::dvec3& point, const glm::dvec3& normal) const;
  glm::dvec3 throughGlass(const glm::dvec3& point, const glm::dvec3& direction) const;

  std::vector<GlazedLancet> windows_;
  double glassPlane_;
  glm::dvec3 toSun_;
  std::vector<Block> blocks_;
  std::vector<Patch> patches_;
};

// Linear light as the factor that textures are multiplied by, in units of `scale`.
glm::vec3 displayed(const glm::dvec3& linear, double scale);

}  // namespace postprocessing
