// What the atrium is made of. Functions of texture coordinates in [0,1).
#pragma once

#include "room/image.h"

namespace water {

// A wall from floor to ceiling, one panel wide: black dado, red field, frieze, garlands. Repeats across.
room::Texel fresco(double u, double v);
// Slabs of stone, with water standing on them where the second is 1; both repeat.
room::Texel slabs(double u, double v);
double puddle(double u, double v);
room::Texel marble(double u, double v);
room::Texel stucco(double u, double v, glm::dvec3 paint);
room::Texel terracotta(double u, double v);
room::Texel bronze(double u, double v);
room::Texel leafTexel(double u, double v);
room::Texel petalTexel(double u, double v);
room::Texel skyTexel(double u, double v);
// The mosaic of the pool at a point of its walls folded down around its bottom; metres from the middle.
glm::dvec3 poolMosaic(glm::dvec2 unfolded);

}  // namespace water
