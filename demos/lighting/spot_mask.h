// The pictures that spotlights project, section 2.2 of the paper, with the ramp that removes what would be
// projected behind them.
#pragma once

#include <array>

#include "light_vectors.h"
#include "room/texture.h"

namespace lighting {

class SpotMask {
 public:
  SpotMask();
  // Destination alpha = attenuation * falloff * ramp, where the ramp is 0 behind the light's near plane;
  // without a cone, the attenuation alone.
  void draw(const LightVectors& lit, int lightIndex, const Spotlight& light, const glm::dmat4& view,
            bool cone) const;

 private:
  std::array<room::Texture, kLights> falloff_;
  room::Texture ramp_;
};

// color += light color * destination alpha: the spot by itself, on white.
void drawSpot(const LightVectors& lit, const Spotlight& light, const glm::dmat4& view);

}  // namespace lighting
