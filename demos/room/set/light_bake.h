// Light in a room that is worked out once, in linear light, for lightmaps and vertices. Lengths in metres.
#pragma once

#include <functional>
#include <vector>

#include "obstacles.h"
#include "room/image.h"
#include "room/mesh.h"

namespace room {

// A point of a surface that light comes to.
struct LitPoint {
  glm::dvec3 position;
  glm::dvec3 normal;  // unit length
  glm::dvec3 start;   // a little above the surface, where rays begin
  double open = 1;    // [0,1]: how much of its surroundings nothing stands in
};

using Openness = std::function<double(const LitPoint&, const Obstacles&)>;
// Linear light of one source, 1 is what makes white look white.
using Source = std::function<glm::dvec3(const LitPoint&, const Obstacles&)>;
// Linear light to half the factor for textures as they are displayed: what is brighter than white fits in
// [0,1].
using Film = glm::dvec3 (*)(const glm::dvec3& light);

// By the distances to what stands within the range, over the hemisphere.
Openness opennessByRays(double range, int rays);
// Less than 1 towards the sides of a box that the point is in: by `share` at a side, by 1/e of that at
// `reach`.
double opennessInBox(const LitPoint& at, const glm::dvec3& low, const glm::dvec3& high, double share,
                     double reach);

glm::dvec3 halfGamma(const glm::dvec3& light);
// Bright light saturates.
glm::dvec3 halfSaturated(const glm::dvec3& light);
// The same for light that is not linear, but was mixed by eye as it is displayed.
glm::dvec3 halfSaturatedAsMixed(const glm::dvec3& light);

struct BakeStyle {
  double start = 4e-3;                          // above the surface, where rays begin
  Openness openness = opennessByRays(1.1, 20);  // none: 1 everywhere
  Film film = halfSaturated;
};

// A glowing ball that shines to all sides.
struct Lamp {
  glm::dvec3 center;
  double radius;
  glm::dvec3 color;     // light on a surface that faces it, a metre away
  bool shadows = true;  // without, it stands for light that a surface throws back
};

// A rectangle that the sky shines through; a x b points into the room.
struct Opening {
  glm::dvec3 corner;
  glm::dvec3 a;
  glm::dvec3 b;
  glm::dvec3 sky;  // light on a surface that sees nothing but sky
};

struct Sun {
  glm::dvec3 toward{0, 1, 0};  // any length
  double radius = 0.012;       // radians
  glm::dvec3 color{0};
};

class LightBake {
 public:
  explicit LightBake(BakeStyle style = {}) : style_(std::move(style)) {}

  void add(const UprightCylinder& cylinder) { obstacles_.add(cylinder); }
  void add(const Block& block) { obstacles_.add(block); }
  void add(const Lamp& lamp);
  void add(const Opening& opening);
  void add(const Sun& sun);
  void add(Source source) { sources_.push_back(std::move(source)); }
  // What there is everywhere, less where things stand near.
  void addAmbient(const glm::dvec3& ambient);

  glm::dvec3 light(const glm::dvec3& point, const glm::dvec3& normal) const;
  // The light as the film shows it.
  glm::vec3 halfLight(const glm::dvec3& point, const glm::dvec3& normal) const;
  // The same over a rectangle; origin, a, b as in room::rectangle.
  Image lightmap(int width, int height, glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b) const;
  // The same for every vertex, which `place` takes to where it is in the room.
  std::vector<glm::vec3> vertexLight(const MeshData& mesh, const glm::dmat4& place = glm::dmat4(1.0)) const;

 private:
  BakeStyle style_;
  Obstacles obstacles_;
  std::vector<Source> sources_;
};

// Points in the unit disc, each for the same share of it.
glm::dvec2 spiral(int i, int count);
// Takes +Z to the axis.
glm::dmat3 framePointing(const glm::dvec3& axis);

// Positions to [0,1]^2 over a rectangle: the texture matrix of its lightmap.
glm::dmat4 rectangleCoordinates(glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b);

}  // namespace room
