// Section 3.7.12: the texture functions and the combiner.
#pragma once

#include <array>

#include "layer/render/state.h"

namespace anteroom::reference {

// The color after all units, from the primary color, what each active unit sampled and the fog factor.
glm::dvec4 applyTextures(const render::State& state, const glm::dvec4& primary,
                         const std::array<glm::dvec4, gen::kMaxTextureUnits>& samples, double fogFactor);

}  // namespace anteroom::reference
