// The light that comes through the chapel's windows.
#pragma once

#include <vector>

#include "room/set/light_bake.h"
#include "stone_and_glass.h"

namespace postprocessing {

struct GlazedLancet {
  Lancet lancet;
  room::Image glass;  // what it lets through, as it is displayed; row 0 at the sill
};

class Daylight {
 public:
  // glassPlane: z of the windows, which the rest of the room is in front of. The windows outlive it.
  Daylight(const std::vector<GlazedLancet>& windows, double glassPlane, const glm::dvec3& toSun);

  // Sources for a LightBake: the sky in the windows with what the room throws back, and the sun, which each
  // pane colors.
  glm::dvec3 sky(const room::LitPoint& at, const room::Obstacles& obstacles) const;
  glm::dvec3 sun(const room::LitPoint& at, const room::Obstacles& obstacles) const;

 private:
  struct Patch {
    glm::dvec3 center;
    glm::dvec3 color;  // linear, times its area
  };
  void addPatches(const GlazedLancet& window);
  glm::dvec3 throughGlass(const glm::dvec3& point, const glm::dvec3& direction) const;

  const std::vector<GlazedLancet>& windows_;
  double glassPlane_;
  glm::dvec3 toSun_;
  std::vector<Patch> patches_;
};

}  // namespace postprocessing
