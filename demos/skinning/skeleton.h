// The hand's twenty bones and what they do. Lengths in millimetres of a life-sized right hand at rest: the
// wrist at the origin, fingers along +y, the palm towards +z, the thumb towards +x.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace skinning {

inline constexpr std::size_t kBones = 20;
inline constexpr std::size_t kFingers = 4;  // index, middle, ring, little
inline constexpr std::size_t kPhalanges = 3;

// Metacarpals that move by themselves; the middle finger's belongs to the hand.
enum Bone : std::size_t {
  kForearm,
  kHand,
  kIndexMetacarpal,
  kRingMetacarpal,
  kLittleMetacarpal,
  kThumb,                // three
  kFinger = kThumb + 3,  // three a finger, from the index to the little finger
};
constexpr std::size_t phalanx(std::size_t finger, std::size_t joint) {
  return kFinger + kPhalanges * finger + joint;
}
static_assert(phalanx(kFingers - 1, kPhalanges - 1) + 1 == kBones);

// Where a bone begins and ends at rest, and how thick the flesh around it is.
struct RestBone {
  std::size_t parent;
  glm::dvec3 from, to;
  double fromRadius, toRadius;
};
const std::array<RestBone, kBones>& restBones();

// For each bone what takes a point of the hand at rest to where it is, `time` seconds into the act: it waves,
// makes a fist, points, opens and begins anew. Every matrix turns and moves only.
std::array<glm::dmat4, kBones> boneMatrices(double time);

// Seconds until the act begins anew.
inline constexpr double kActLength = 16;

}  // namespace skinning
