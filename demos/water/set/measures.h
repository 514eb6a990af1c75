// Where things are in the atrium. Metres, y up, the floor at 0.
#pragma once

#include <glm/glm.hpp>

namespace water {

inline constexpr glm::dvec3 kRoomMin{-4.2, 0.0, -4.6};
inline constexpr glm::dvec3 kRoomMax{4.2, 4.3, 5.9};
inline constexpr double kPanel = 2.1;  // of the walls' paintings: both sides are multiples of it

// The pool lies beneath the opening of the roof.
inline constexpr glm::dvec2 kPoolCenter{0.0, -0.3};  // x, z
inline constexpr glm::dvec2 kPoolHalf{1.9, 1.9};
inline constexpr double kWaterLevel = -0.09;
inline constexpr double kPoolBottom = -0.74;
inline constexpr double kPoolDepth = kWaterLevel - kPoolBottom;
// The half side of the pool with its walls folded down.
inline constexpr double kUnfoldedPool = kPoolHalf.x + kPoolDepth - kWaterLevel;

inline constexpr double kFloorExtent = 4.2;  // that one repeat of the floor's base map covers
inline constexpr double kColumnX = 2.45;
inline constexpr glm::dvec2 kColumnZ{-2.75, 2.15};

}  // namespace water
