// The shapes of the trash can and its lid.
#pragma once

#include "room/image.h"

namespace lighting {

room::SurfaceFunction canSurface();
room::Texel canTexel(double u, double v);
room::SurfaceFunction lidSurface();
room::Texel lidTexel(double u, double v);

inline constexpr double kCanHeight = 0.80;
double canRadius(double y);

}  // namespace lighting
