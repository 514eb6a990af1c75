// What the chapel is built of.
#pragma once

#include "room/image.h"

namespace postprocessing {

// Metres that one repeat covers.
inline constexpr double kAshlarExtent = 2.4;
inline constexpr double kFlagstoneExtent = 2.4;

// Walls of squared stones in courses; repeats seamlessly, as does the next.
room::Texel ashlar(double u, double v);
// A floor of worn slabs.
room::Texel flagstones(double u, double v);
room::Texel brass(double u, double v);

// A window with a pointed arch: an equilateral one, whose arcs have the opposite springers as their centres.
struct Lancet {
  double center;  // x of the axis, metres
  double width;   // of the glass
  double sill;    // height of the lower edge
  double spring;  // height where the arch begins

  // Height of the arch at x metres beside the axis.
  double archAt(double x) const;
  double top() const { return archAt(0); }
  // Metres from a point beside the axis to the nearest edge, negative outside.
  double inset(double x, double y) const;
};

// Leaded glass in the lancet's bounding rectangle: diamond panes, medallions and a coloured border.
glm::dvec3 stainedGlass(const Lancet& lancet, double u, double v);

}  // namespace postprocessing
