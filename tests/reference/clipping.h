// Section 2.11: primitives against the view volume and the user's planes, in clip coordinates.
#pragma once

#include <vector>

#include "tests/reference/vertex_processing.h"

namespace anteroom::reference {

bool pointIsVisible(const Vertex& point, const gen::State& fixed);
// False: nothing is left.
bool clipLine(Vertex& a, Vertex& b, const gen::State& fixed);
// A convex polygon; empty when nothing is left. Left and right, bottom and top are the scissor's business:
// they are clipped far outside, where coordinates would no longer fit the rasteriser.
std::vector<Vertex> clipPolygon(std::vector<Vertex> polygon, const gen::State& fixed);

}  // namespace anteroom::reference
