// Shadows on floor and walls, section 2.4 of the paper: things flattened onto a plane, and a stencil that
// darkens each pixel once.
#pragma once

#include <GLES/gl.h>

#include "set/scene.h"

namespace lighting {

// What the base pass leaves in the stencil of a surface, so that its shadows stay on it.
GLuint stencilOf(Receiver receiver);

// Takes from destination alpha where the light does not reach; alone: darkens the color instead.
void drawShadows(const Scene& scene, int lightIndex, const glm::dmat4& view, bool alone);

}  // namespace lighting
