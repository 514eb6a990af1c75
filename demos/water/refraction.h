// Refraction mapping, section 3.1 of the paper: where the bent ray from the eye meets the pool is where the
// pool's picture is looked up.
#pragma once

#include <glm/glm.hpp>

#include "room/texture.h"
#include "sheet.h"

namespace water {

struct Refracted {
  glm::dvec2 texCoord;  // in the pool's picture
  glm::dvec2 place;     // where that is, x and z from the middle of the pool
  glm::dvec3 left;      // [0,1], what the way through the water leaves of the light
};
// position: of the surface, x and z from the middle of the pool; toward: from the eye, unit length.
Refracted refracted(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& toward);

// The pool's picture has its walls folded down about its bottom. unfolded: metres from the middle.
glm::dvec2 poolTexCoord(glm::dvec2 unfolded);

// Unit 0: the pool's picture * what the water brings and leaves of its light.
void useRefraction(const Sheet& sheet, const room::Texture& poolPicture);

}  // namespace water
