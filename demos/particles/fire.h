// The particle system, section 6.1 of the paper: where each particle is, how large and of what color, as
// closed forms of the time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flicker.h"

namespace particles {

// The arrays that GL reads, one entry a particle.
struct ParticleArrays {
  std::vector<glm::vec3> positions;  // metres, world
  std::vector<glm::vec4> colors;     // premultiplied by their alpha; flames have none and so only add
  std::vector<float> sizes;          // before attenuation

  void resize(std::size_t count);
};

class Fire {
 public:
  // base: the centre of the emitter; count: how many particles.
  Fire(glm::dvec3 base, int count);
  Flicker flicker(double time) const;
  // sizeScale: what makes a size that is meant for a VGA screen, seen from a metre, the array's.
  void evaluate(double time, double sizeScale, ParticleArrays& out) const;

 private:
  struct Particle {
    glm::dvec3 position;
    glm::dvec4 color;
    double size;
  };
  Particle smoke(int index, int cycle, double age, double time) const;
  Particle flame(int index, int cycle, double age, double time, double life) const;
  Particle ember(int index, int cycle, double age, double time) const;
  glm::dvec2 wind(double time, double height) const;

  glm::dvec3 base_;
  int count_;
  double gain_;
  NoiseTable noise_;
};

// The soft picture of one particle, luminance and alpha.
room::Image flameImage();

}  // namespace particles
