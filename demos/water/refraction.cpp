#include "refraction.h"

#include <algorithm>
#include <cmath>

#include "room/passes.h"
#include "set/atrium.h"
#include "set/measures.h"

namespace water {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kAirToWater = 1 / 1.33;
constexpr dvec3 kAbsorption(0.55, 0.16, 0.12);  // a metre

// Where a ray from a point in the water meets the bottom or a wall.
struct PoolHit {
  dvec2 place;
  dvec2 unfolded;
  double length;
};
PoolHit hitPool(const dvec3& from, const dvec3& direction) {
  const dvec2 ground(from.x, from.z);
  const dvec2 along(direction.x, direction.z);
  double t = (kPoolBottom - from.y) / std::min(direction.y, -1e-3);
  int wall = -1;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(along[axis]) < 1e-9) continue;
    const double toWall = (std::copysign(kPoolHalf[axis], along[axis]) - ground[axis]) / along[axis];
    if (toWall < t) {
      t = std::max(toWall, 0.0);
      wall = axis;
    }
  }
  const dvec2 place = glm::clamp(ground + along * t, -kPoolHalf, kPoolHalf);
  dvec2 unfolded = place;
  // A wall is folded down about its foot.
  if (wall >= 0) unfolded[wall] += std::copysign(from.y + direction.y * t - kPoolBottom, along[wall]);
  return {place, unfolded, t};
}

}  // namespace

Refracted refracted(const dvec3& position, const dvec3& normal, const dvec3& toward) {
  const PoolHit hit = hitPool(position, glm::refract(toward, normal, kAirToWater));
  return {poolTexCoord(hit.unfolded), hit.place, glm::exp(-kAbsorption * hit.length)};
}

dvec2 poolTexCoord(dvec2 unfolded) {
  return unfolded / (2 * kUnfoldedPool) + 0.5;
}

void useRefraction(const Sheet& sheet, const room::Texture& poolPicture) {
  room::useTexture(0, poolPicture);
  // Twice, as caustics may double the light.
  room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 2 * kLightScale);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  sheet.bindTexCoords();
  glEnableClientState(GL_COLOR_ARRAY);
  sheet.bindColors();
}

}  // namespace water
