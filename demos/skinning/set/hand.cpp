#include "hand.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <numeric>

namespace skinning {
namespace {

using glm::dvec2;
using glm::dvec3;

// ---- Distances: negative inside

double capsule(const dvec3& p, const dvec3& from, const dvec3& to, double fromRadius, double toRadius) {
  const dvec3 along = to - from;
  const double t = glm::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(p - from - along * t) - glm::mix(fromRadius, toRadius, t);
}

double capsule(const dvec3& p, const RestBone& bone) {
  return capsule(p, bone.from, bone.to, bone.fromRadius, bone.toRadius);
}

// The union of two bodies, with a fillet of about `round` where they meet.
double joined(double a, double b, double round) {
  const double h = std::max(round - std::abs(a - b), 0.0) / round;
  return std::min(a, b) - h * h * h * round / 6;
}

double finger(const dvec3& p, std::size_t number) {
  double d = 1e9;
  for (std::size_t joint = 0; joint < kPhalanges; ++joint) {
    const RestBone& bone = restBones()[phalanx(number, joint)];
    d = joined(d, capsule(p, bone), 3);
    // The pad on the palm's side.
    const dvec3 along = glm::normalize(bone.to - bone.from);
    const dvec3 palm = glm::normalize(dvec3(0, 0, 1) - along * along.z);
    const dvec3 low = glm::mix(bone.from, bone.to, 0.3) + palm * (0.26 * bone.fromRadius);
    const dvec3 high = glm::mix(bone.from, bone.to, joint == 2 ? 0.85 : 0.72) + palm * (0.22 * bone.toRadius);
    d = joined(d, capsule(p, low, high, 0.84 * bone.fromRadius, 0.88 * bone.toRadius), 4);
    // The joint.
    d = joined(d, glm::length(p - bone.from + palm * 1.2) - (joint == 0 ? 1.02 : 1.08) * bone.fromRadius, 4);
  }
  return d;
}

double thumb(const dvec3& p) {
  double d = capsule(p, restBones()[kThumb]);
  d = joined(d, capsule(p, restBones()[kThumb + 1]), 5);
  d = joined(d, capsule(p, restBones()[kThumb + 2]), 4);
  const RestBone& tip = restBones()[kThumb + 2];
  return joined(d, glm::length(p - glm::mix(tip.from, tip.to, 0.45) - dvec3(-1.5, 1, 2)) - 9.4, 5);
}

double palm(const dvec3& p) {
  double d = capsule(p, restBones()[kHand].from + dvec3(0, 12, -1), restBones()[kHand].to, 15, 10.5);
  for (Bone bone : {kIndexMetacarpal, kRingMetacarpal, kLittleMetacarpal})
    d = joined(d, capsule(p, restBones()[bone]), 13);
  // The balls of the thumb and of the little finger, and the soft edge below the fingers.
  d = joined(d, capsule(p, {17, 16, 9}, {33, 44, 13}, 15, 15.5), 11);
  d = joined(d, capsule(p, {-20, 14, 5}, {-28, 50, 5}, 14, 12), 11);
  d = joined(d, capsule(p, {-24, 76, 5}, {25, 84, 5}, 9, 9.5), 9);
  return d;
}

double forearm(const dvec3& p) {
  const dvec3 flat(p.x, p.y, p.z * 1.28);
  return 0.8 * capsule(flat, {0, -140, 0}, {0, 2, 0}, 33, 23.5);
}

double hand(const dvec3& p) {
  double fingers = finger(p, 0);
  for (std::size_t i = 1; i < kFingers; ++i) fingers = joined(fingers, finger(p, i), 3.5);
  const double body = joined(palm(p), forearm(p), 20);
  return joined(joined(body, thumb(p), 9), fingers, 8);
}

dvec3 normalAt(const dvec3& p) {
  constexpr double kStep = 0.05;
  dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 step(0);
    step[axis] = kStep;
    gradient[axis] = hand(p + step) - hand(p - step);
  }
  return glm::normalize(gradient);
}

// From inside to the skin, but no further than `most`: what does not get there stays inside the hand, unseen.
dvec3 outwards(const dvec3& from, const dvec3& direction, double most) {
  double t = 0;
  for (int i = 0; i < 120 && t < most; ++i) {
    const double d = -hand(from + direction * t);
    if (d < 1e-4) break;
    t += d;
  }
  return from + direction * std::min(t, most);
}

// ---- Weights

// How far a bone's flesh is: what is near it follows it.
double fleshDistance(const dvec3& p, std::size_t bone) {
  if (bone == kForearm) return forearm(p);
  if (bone == kHand)
    return std::min(capsule(p, restBones()[kHand]), capsule(p, {-2, 4, 0}, {0, 60, 0}, 20, 16));
  return capsule(p, restBones()[bone]);
}

void setWeights(SkinVertex& vertex) {
  constexpr double kSharpness = 0.42;  // a millimetre
  std::array<double, kBones> strength;
  std::array<std::size_t, kBones> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  double nearest = 1e9;
  for (std::size_t bone = 0; bone < kBones; ++bone)
    nearest = std::min(nearest, strength[bone] = fleshDistance(dvec3(vertex.position), bone));
  for (double& s : strength) s = std::exp(-kSharpness * (s - nearest));
  std::partial_sort(order.begin(), order.begin() + kInfluences, order.end(),
                    [&](std::size_t a, std::size_t b) { return strength[a] > strength[b]; });
  // What the fifth would have had is taken from all, so that none appears or goes at once.
  double fifth = 0, sum = 0;
  for (std::size_t k = kInfluences; k < kBones; ++k) fifth = std::max(fifth, strength[order[k]]);
  for (std::size_t k = 0; k < kInfluences; ++k) sum += strength[order[k]] - fifth;
  for (std::size_t k = 0; k < kInfluences; ++k) {
    vertex.bones[k] = static_cast<std::uint8_t>(order[k]);
    vertex.weights[k] = static_cast<float>((strength[order[k]] - fifth) / sum);
  }
}

// ---- Patches

// A ray from inside the hand for (around, along) in [0,1]^2. around: from the thumb's side over the palm's
// side and back behind.
struct Ray {
  dvec3 from, direction;
  double most;
};
using RayFunction = std::function<Ray(double around, double along)>;

dvec2 chart(const dvec3& p, bool back) {
  const dvec2 uv = (dvec2(p) - kChartLow) / (kChartHigh - kChartLow);
  return {0.5 * uv.x + (back ? 0.5 : 0.0), uv.y};
}

// Two halves of `half` columns of cells each: one over the palm's side, one over the back, whose shared edges
// are there twice, as they lie in both halves of the texture.
void addPatch(HandMesh& mesh, int half, int rows, const RayFunction& ray) {
  const int columns = 2 * (half + 1);
  const std::size_t base = mesh.vertices.size();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool back = column > half;
      const double around = 0.5 * (back ? 1 + static_cast<double>(column - half - 1) / half
                                        : static_cast<double>(column) / half);
      const Ray r = ray(around, static_cast<double>(row) / (rows - 1));
      const dvec3 p = outwards(r.from, glm::normalize(r.direction), r.most);
      SkinVertex& vertex = mesh.vertices.emplace_back();
      vertex.position = p;
      vertex.normal = normalAt(p);
      vertex.uv = chart(p, back);
      setWeights(vertex);
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      if (column == half) continue;
      const auto a = static_cast<int>(base) + row * columns + column;
      for (int index : {a, a + columns, a + 1, a + 1, a + columns, a + columns + 1})
        mesh.indices.push_back(static_cast<std::uint16_t>(index));
    }
  }
}

// A chain of bones with a round end. `start`: how far below its first joint it begins, in the flesh of the
// palm.
class Chain {
 public:
  Chain(std::size_t first, double start, const dvec3& palm) : palm_(palm) {
    const RestBone& root = restBones()[first];
    points_.push_back(root.from - glm::normalize(root.to - root.from) * start);
    for (std::size_t joint = 0; joint < kPhalanges; ++joint) {
      points_.push_back(joint == 0 ? root.from : restBones()[first + joint].from);
      radii_.push_back(restBones()[first + joint].fromRadius);
    }
    points_.push_back(restBones()[first + kPhalanges - 1].to);
    radii_.push_back(restBones()[first + kPhalanges - 1].toRadius);
    for (std::size_t i = 1; i < points_.size(); ++i) length_ += glm::distance(points_[i], points_[i - 1]);
  }

  Ray operator()(double around, double along) const {
    constexpr double kCap = 0.86;  // from here on rays turn towards the tip
    double at = std::min(along / kCap, 1.0) * length_;
    std::size_t i = 1;
    while (i + 1 < points_.size() && at > glm::distance(points_[i], points_[i - 1])) {
      at -= glm::distance(points_[i], points_[i - 1]);
      ++i;
    }
    const double leg = glm::distance(points_[i], points_[i - 1]);
    const dvec3 axis = direction(i);
    // Near a joint rays share the bend, so that they do not cross.
    const double share = glm::clamp(at / leg, 0.0, 1.0);
    const dvec3 before = glm::normalize(axis + direction(std::max<std::size_t>(i - 1, 1)));
    const dvec3 after = glm::normalize(axis + direction(std::min(i + 1, points_.size() - 1)));
    const dvec3 y = glm::normalize(share < 0.5 ? glm::mix(before, axis, 2 * share)
                                               : glm::mix(axis, after, 2 * share - 1));
    const dvec3 x = glm::normalize(glm::cross(y, palm_));
    const dvec3 z = glm::cross(x, y);
    const double angle = glm::two_pi<double>() * around;
    const dvec3 radial = x * std::cos(angle) + z * std::sin(angle);
    const double rise = std::max(along - kCap, 0.0) / (1 - kCap) * glm::half_pi<double>();
    const double radius = radii_[std::min(i - 1, radii_.size() - 1)];
    return {glm::mix(points_[i - 1], points_[i], share), radial * std::cos(rise) + y * std::sin(rise),
            1.62 * radius};
  }

 private:
  dvec3 direction(std::size_t leg) const { return glm::normalize(points_[leg] - points_[leg - 1]); }

  dvec3 palm_;
  std::vector<dvec3> points_;
  std::vector<double> radii_;
  double length_ = 0;
};

// The forearm and the palm up to the roots of the fingers. Rays end in the flesh of fingers and thumb, whose
// own patches cover them.
Ray palmRay(double around, double along) {
  constexpr double kLow = -112, kHigh = 76, kCap = 0.80;
  const double y = glm::mix(kLow, kHigh, std::min(along / kCap, 1.0));
  const double open = glm::smoothstep(-10.0, 50.0, y);
  const double angle = glm::two_pi<double>() * around;
  const double rise = std::max(along - kCap, 0.0) / (1 - kCap) * glm::half_pi<double>();
  // Rays lean sideways where the palm is broad and flat.
  const dvec3 flat(glm::mix(1.15, 2.6, open) * std::cos(angle), 0, std::sin(angle));
  const dvec3 direction = glm::normalize(flat) * std::cos(rise) + dvec3(0, 1, 0) * std::sin(rise);
  const double thumb = glm::smoothstep(2.0, 16.0, y) * (1 - glm::smoothstep(44.0, 62.0, y));
  const dvec3 reach(direction.x > 0 ? glm::mix(47.0, 31.0, thumb) : 47.0, 27, 40);
  return {{0, y, glm::mix(0.0, 2.0, open)}, direction, 1 / glm::length(direction / reach)};
}

}  // namespace

HandMesh makeHand() {
  HandMesh mesh;
  mesh.vertices.reserve(kHandVertices);
  addPatch(mesh, 19, 51, palmRay);
  for (std::size_t i = 0; i < kFingers; ++i) addPatch(mesh, 8, 42, Chain(phalanx(i, 0), 14, {0, 0, 1}));
  addPatch(mesh, 8, 39, Chain(kThumb, 4, glm::normalize(dvec3(-0.62, 0.30, 0.72))));
  return mesh;
}

}  // namespace skinning
