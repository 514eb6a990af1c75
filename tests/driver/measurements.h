// How exact the driver is where Vulkan leaves it room. Each measurement draws with hand-written shaders and
// returns the greatest error against float64. Colors run from 0 to 1 and are read from 8 bits, so that their
// errors hold that rounding.
#pragma once

#include "device.h"

namespace driver {

// Two triangles in clip coordinates whose value runs from (s0, t0) to (s1, t1).
std::vector<Vertex> rectangle(float x0, float y0, float x1, float y1, float s0, float t0, float s1, float t1);

double filterWeights(Device& device);               // of a color, at the greatest contrast
double levelOfDetail(Device& device);               // in levels, where rho is the same everywhere
double levelOfDetailInPerspective(Device& device);  // in levels, on floors
double anisotropy(Device& device);                  // in levels
double power(Device& device);                       // of x^y for x in (0, 1], y in [0, 128]
double exponential(Device& device);                 // of e^-x for x in [0, 16]
double blending(Device& device);                    // of a color in 8 bits, a pass
double lineParameter(Device& device);               // of what runs from 0 to 1 along 26 pixels
double smoothLineCoverage(Device& device);          // of a pixel's covered part

}  // namespace driver
