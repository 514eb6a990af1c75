// The state that rendering passes are put together from.
#pragma once

#include <GLES/gl.h>

#include <glm/glm.hpp>

#include "mesh.h"
#include "texture.h"

namespace room {

// What passes start from: positions alone, in white, units 0 to units - 1 off and as they were at first,
// depth tested and written, back faces culled, no blending, lighting or stencil test.
void resetPasses(int units);
// Makes the unit active, with the 2D texture enabled and bound.
void useTexture(int unit, const Texture& texture);
// For the active unit: RGB = scale * (first * second) or scale * dot(first, second), alpha = that of the unit
// before.
void combine(GLenum mode, GLenum first, GLenum second, float scale = 1);
// For the active unit: the texture times what comes from the unit before.
void modulate();
// Clamped to [0,1] here, since not every implementation clamps the current color before it is used.
void setColor(const glm::dvec3& rgb, double alpha = 1);
// Texture coordinates of a unit from the mesh's own coordinates or from its positions.
void useTexCoords(int unit, const Mesh& mesh, bool positions = false);
// Makes the unit active; leaves the matrix mode at GL_MODELVIEW.
void loadTextureMatrix(int unit, const glm::dmat4& m);

}  // namespace room
