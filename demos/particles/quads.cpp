#include "quads.h"

#include <algorithm>
#include <cmath>

#include "room/transform.h"

namespace particles {
namespace {

constexpr std::size_t kBatch = 16384;  // quads: as many as 16-bit indices reach

}  // namespace

// What the points are, section 3.3 of the specification, for particles first .. first + count.
void Quads::make(const ParticleArrays& particles, const Attenuation& attenuation, const glm::dmat4& view,
                 double pixelAtOne, std::size_t first, std::size_t count) {
  constexpr std::array<glm::vec2, 4> kCorners = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  positions_.clear();
  colors_.clear();
  texCoords_.clear();
  for (std::size_t i = first; i < first + count; ++i) {
    const glm::dvec3 eye(view * glm::dvec4(particles.positions[i], 1.0));
    const double derived = particles.sizes[i] * attenuation.at(glm::length(eye));
    const double pixels = std::clamp<double>(derived, sizeRange_[0], sizeRange_[1]);
    const double metres = pixels * pixelAtOne * -eye.z;
    for (const glm::vec2& corner : kCorners) {
      // Row 0 of a point sprite's texture is above.
      positions_.emplace_back(eye + glm::dvec3((corner.x - 0.5) * metres, (0.5 - corner.y) * metres, 0));
      colors_.push_back(particles.colors[i]);
      texCoords_.push_back(corner);
    }
  }
  for (std::size_t quad = indices_.size() / 6; quad < count; ++quad) {
    for (std::size_t corner : {0, 1, 2, 0, 2, 3})
      indices_.push_back(static_cast<GLushort>(4 * quad + corner));
  }
}

void Quads::draw(const ParticleArrays& particles, const Attenuation& attenuation, const room::Camera& camera,
                 double fieldOfView, int height) {
  const double pixelAtOne = 2 * std::tan(glm::radians(fieldOfView) / 2) / height;
  room::loadMatrix(glm::dmat4(1.0));
  glEnableClientState(GL_COLOR_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  for (std::size_t first = 0; first < particles.positions.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, particles.positions.size() - first);
    make(particles, attenuation, camera.view, pixelAtOne, first, count);
    glVertexPointer(3, GL_FLOAT, 0, positions_.data());
    glColorPointer(4, GL_FLOAT, 0, colors_.data());
    glTexCoordPointer(2, GL_FLOAT, 0, texCoords_.data());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count), GL_UNSIGNED_SHORT, indices_.data());
  }
  room::loadMatrix(camera.view);
}

}  // namespace particles
