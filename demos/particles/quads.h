// The particles as screen-aligned quads that the program makes, section 6.2 of the paper: what point sprites
// save.
#pragma once

#include "points.h"
#include "room/camera.h"

namespace particles {

class Quads {
 public:
  Quads() : sizeRange_(pointSizeRange()) {}
  // The same picture as Points::draw's. fieldOfView: the camera's, degrees. Loads the camera's matrix again.
  void draw(const ParticleArrays& particles, const Attenuation& attenuation, const room::Camera& camera,
            double fieldOfView, int height);

 private:
  void make(const ParticleArrays& particles, const Attenuation& attenuation, const glm::dmat4& view,
            double pixelAtOne, std::size_t first, std::size_t count);

  std::array<GLfloat, 2> sizeRange_;  // pixels, of points
  std::vector<glm::vec3> positions_;  // eye coordinates
  std::vector<glm::vec4> colors_;
  std::vector<glm::vec2> texCoords_;
  std::vector<GLushort> indices_;
};

}  // namespace particles
