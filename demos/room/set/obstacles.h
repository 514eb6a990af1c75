// Simple shapes that stand in the way of light. Lengths in metres.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace room {

// A shape is a little smaller than what it stands for, so that surfaces do not shadow themselves.
struct UprightCylinder {
  glm::dvec3 foot;
  double radius;
  double height;
};

struct Block {
  glm::dvec3 center;
  glm::dvec3 half;
  double turn = 0;  // radians about y
};

class Obstacles {
 public:
  struct PlacedBlock {
    glm::dvec3 center;
    glm::dvec3 half;
    double cosine;
    double sine;

    // A vector turned back into the block's axes.
    glm::dvec3 local(const glm::dvec3& v) const {
      return {cosine * v.x - sine * v.z, v.y, sine * v.x + cosine * v.z};
    }
  };

  void add(const UprightCylinder& cylinder) { cylinders_.push_back(cylinder); }
  void add(const Block& block);
  const std::vector<UprightCylinder>& cylinders() const { return cylinders_; }
  const std::vector<PlacedBlock>& blocks() const { return blocks_; }

  // Whether anything is on the way from a point to from + way.
  bool blocked(const glm::dvec3& from, const glm::dvec3& way) const;
  // The share of the way before it meets the first of them, 1 if it meets none.
  double freeShare(const glm::dvec3& from, const glm::dvec3& way) const;
  // Those that may reach to within a distance of a point.
  Obstacles within(const glm::dvec3& point, double distance) const;

 private:
  std::vector<UprightCylinder> cylinders_;
  std::vector<PlacedBlock> blocks_;
};

}  // namespace room
