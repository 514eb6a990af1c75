#include "reflection.h"

#include <algorithm>
#include <cmath>

#include "room/passes.h"
#include "set/measures.h"

namespace water {
namespace {

constexpr int kCubeSize = 256;

}  // namespace

Reflection::Reflection(const room::FramebufferFunctions& gl)
    : mapping_("water"), surroundings_(gl, kCubeSize) {}

void Reflection::render(const std::function<void(const room::Camera&)>& draw) {
  // From the middle of the surface; what is drawn stands still around it.
  const glm::dvec3 middle(kPoolCenter.x, 0.12, kPoolCenter.y);
  for (int face = 0; face < 6; ++face) {
    surroundings_.bind(face);
    draw({middle, room::cubeFaceCamera(face, middle), room::cubeFaceProjection(0.05, 25.0)});
  }
  surroundings_.unbind();
}

void Reflection::begin(const glm::dmat4& view, bool overRefraction) const {
  mapping_.enable(1, surroundings_, view);
  room::combine(overRefraction ? GL_INTERPOLATE : GL_REPLACE, GL_TEXTURE, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
}

void Reflection::end() const {
  mapping_.disable(1);
}

// Schlick's approximation of Fresnel's formula, with a little more than nature's share at right angles.
double reflectedShare(double cosine) {
  const double grazing = 1 - std::clamp(cosine, 0.0, 1.0);
  return 0.09 + 0.91 * std::pow(grazing, 3.2);
}

}  // namespace water
