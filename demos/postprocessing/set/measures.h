// Where things are in the chapel. Metres, y up, the windows at the far end of the z axis.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace postprocessing {

inline constexpr glm::dvec3 kRoomMin{-3.6, 0.0, -6.0};
inline constexpr glm::dvec3 kRoomMax{3.6, 6.3, 5.4};
inline constexpr double kEaves = 4.6;
inline constexpr double kRidge = kRoomMax.y;
inline constexpr double kColumnX = 2.05;
inline constexpr std::array<double, 3> kColumnZ = {-3.4, -0.6, 2.2};
inline constexpr double kColumnTop = 4.20;
inline constexpr glm::dvec3 kLampPivot{0.0, 5.9, -1.7};

}  // namespace postprocessing
