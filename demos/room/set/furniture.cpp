#include "furniture.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "materials.h"
#include "room/noise.h"

namespace room {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

dmat4 placed(const dvec3& position, double turn) {
  return glm::rotate(glm::translate(dmat4(1.0), position), turn, dvec3(0, 1, 0));
}

MeshData board(const dvec3& size, int number) {
  return box(size, 0.4, 1.0 / kWoodExtent, {hash(number, 1, 7), hash(number, 2, 7)});
}

namespace {

// Planks inside a frame of boards, with a brace across. The frames meet edge to edge: nothing overlaps.
MeshData crateSide(dvec2 size, double thick, int number) {
  MeshData mesh;
  constexpr double kFrame = 0.085;
  constexpr int kPlanks = 5;
  // The planks end behind the frame, or they would show through the neighbouring sides.
  const dvec2 span = size - kFrame;
  const double plank = span.y / kPlanks;
  for (int i = 0; i < kPlanks; ++i) {
    mesh.append(board({span.x, plank - 0.006, thick}, number + i),
                glm::translate(dmat4(1.0), dvec3(0, plank * (i + 0.5) - span.y / 2, -thick * 1.5)));
  }
  const dvec2 inner = size - 2 * kFrame;
  for (double sign : {-1.0, 1.0}) {
    mesh.append(board({kFrame, size.y, thick}, ++number),
                glm::translate(dmat4(1.0), dvec3(sign * (size.x - kFrame) / 2, 0, -thick / 2)));
    mesh.append(board({inner.x, kFrame, thick}, ++number),
                glm::translate(dmat4(1.0), dvec3(0, sign * (size.y - kFrame) / 2, -thick / 2)));
  }
  const double angle = std::atan2(inner.y, inner.x);
  const double length = glm::length(inner) - 0.06;
  mesh.append(board({length, 0.06, thick * 0.7}, ++number),
              glm::translate(glm::rotate(dmat4(1.0), angle, dvec3(0, 0, 1)), dvec3(0, 0, -thick * 0.6)));
  for (Vertex& v : mesh.vertices) v.side = dvec3(0, 0, 1);
  return mesh;
}

}  // namespace

MeshData crate(double side) {
  constexpr double kThick = 0.022;
  const double half = side / 2;
  MeshData mesh;
  for (int face = 0; face < 4; ++face) {
    const dmat4 turned = glm::rotate(dmat4(1.0), face * glm::half_pi<double>(), dvec3(0, 1, 0));
    const double width = face % 2 == 0 ? side : side - 2 * kThick;
    mesh.append(crateSide({width, side - kThick}, kThick, 10 * face),
                glm::translate(turned, dvec3(0, -kThick / 2, half)));
  }
  const dmat4 up = glm::rotate(dmat4(1.0), -glm::half_pi<double>(), dvec3(1, 0, 0));
  mesh.append(crateSide({side, side}, kThick, 40), glm::translate(up, dvec3(0, 0, half)));
  return mesh;
}

}  // namespace room
