// Sections 2.6 and 2.8: which vertices make which primitive.
#pragma once

#include <functional>
#include <vector>

#include "layer/render/renderer.h"

namespace anteroom::reference {

// The array elements that a call reads, in order.
std::vector<int64_t> elements(const render::DrawCall& call);

// Calls `emit` with the positions in elements() of each primitive's vertices: 1, 2 or 3 of them, the
// provoking vertex last, triangles with their orientation kept.
void assemble(GLenum mode, size_t count, const std::function<void(const std::vector<size_t>&)>& emit);

}  // namespace anteroom::reference
