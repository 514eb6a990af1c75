// Sections 3.7.5 to 3.7.8 and OES_texture_cube_map: from texture coordinates to a filtered color.
#pragma once

#include "tests/reference/image_store.h"
#include "tests/reference/rasterisation.h"

namespace anteroom::reference {

// The color that a fragment's unit reads, components filled by Table 3.11. Cube maps are filtered across the
// edges of their faces, as Vulkan filters them.
glm::dvec4 sampleTexture(const render::State& state, int unit, const Fragment& fragment);

}  // namespace anteroom::reference
