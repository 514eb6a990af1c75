// A wooden train. Each vehicle stands on the origin, heads along x and is about 0.3 m long.
#pragma once

#include "thing.h"

namespace reflect {

inline constexpr int kVehicles = 6;
inline constexpr double kTrackRadius = 1.16;      // metres
inline constexpr double kRailTop = 0.045;         // height of the rails over the floor
inline constexpr double kVehicleSpacing = 0.345;  // metres along the track

Painted vehicle(int number, const Detail& detail);
Painted track(const Detail& detail);
// Where a vehicle is at a time, seconds.
glm::dmat4 vehicleAt(int number, double time);

}  // namespace reflect
