// Light in a room that is worked out once, in linear light, for lightmaps and vertices. Lengths in metres.
#pragma once

#include <vector>

#include "obstacles.h"
#include "room/image.h"
#include "room/mesh.h"

namespace room {

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
  void add(const UprightCylinder& cylinder) { obstacles_.add(cylinder); }
  void add(const Block& block) { obstacles_.add(block); }
  void add(const Lamp& lamp) { lamps_.push_back(lamp); }
  void add(const Opening& opening) { openings_.push_back(opening); }
  void setSun(const Sun& sun) { sun_ = sun; }
  // What there is everywhere, less where things stand near.
  void setAmbient(const glm::dvec3& ambient) { ambient_ = ambient; }

  glm::dvec3 light(const glm::dvec3& point, const glm::dvec3& normal) const;
  // The factor for textures as they are displayed, halved, so that what is brighter than white fits in [0,1].
  glm::vec3 halfLight(const glm::dvec3& point, const glm::dvec3& normal) const;
  // The same over a rectangle; origin, a, b as in room::rectangle.
  Image lightmap(int width, int height, glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b) const;
  // The same for every vertex.
  std::vector<glm::vec3> vertexLight(const MeshData& mesh) const;

 private:
  double openness(const glm::dvec3& point, const glm::dvec3& normal) const;
  glm::dvec3 lampLight(const glm::dvec3& start, const glm::dvec3& normal) const;
  glm::dvec3 skyLight(const glm::dvec3& start, const glm::dvec3& normal) const;
  glm::dvec3 sunLight(const glm::dvec3& start, const glm::dvec3& normal) const;

  Obstacles obstacles_;
  std::vector<Lamp> lamps_;
  std::vector<Opening> openings_;
  Sun sun_;
  glm::dvec3 ambient_{0};
};

// Positions to [0,1]^2 over a rectangle: the texture matrix of its lightmap.
glm::dmat4 rectangleCoordinates(glm::dvec3 origin, glm::dvec3 a, glm::dvec3 b);

}  // namespace room
