#include "skeleton.h"

#include <bit>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

namespace skinning {
namespace {

using glm::dmat4;
using glm::dvec3;

struct FingerShape {
  dvec3 carpal, knuckle;  // ends of the metacarpal
  double lean;            // degrees from +y towards +x
  std::array<double, kPhalanges> lengths;
  std::array<double, kPhalanges + 1> radii;
};
constexpr std::array<FingerShape, kFingers> kFingerShapes = {{
    {{11, 8, -1}, {29, 91, -1}, 13, {43, 26, 21}, {10.8, 9.3, 8.2, 6.6}},
    {{4, 9, -2}, {9, 95, -3}, 3.5, {47, 30, 22}, {11.0, 9.4, 8.4, 6.8}},
    {{-4, 9, -2}, {-11, 90, -2}, -7, {43, 28, 22}, {10.4, 8.9, 7.9, 6.4}},
    {{-11, 7, 0}, {-29, 80, 0}, -18, {34, 21, 19}, {9.3, 7.8, 6.9, 5.6}},
}};

std::array<RestBone, kBones> makeRestBones() {
  std::array<RestBone, kBones> bones;
  bones[kForearm] = {kForearm, {0, -120, 0}, {0, 0, 0}, 31, 23};
  bones[kHand] = {kForearm, {0, 0, 0}, kFingerShapes[1].knuckle, 20, 11};
  const auto metacarpal = [&](Bone bone, std::size_t finger) {
    bones[bone] = {kHand, kFingerShapes[finger].carpal, kFingerShapes[finger].knuckle, 13,
                   kFingerShapes[finger].radii[0]};
  };
  metacarpal(kIndexMetacarpal, 0);
  metacarpal(kRingMetacarpal, 2);
  metacarpal(kLittleMetacarpal, 3);
  const std::array<dvec3, 4> thumb = {dvec3(18, 14, 7), dvec3(46, 47, 21), dvec3(62, 75, 27),
                                      dvec3(71, 99, 30)};
  const std::array<double, 4> thumbRadii = {15, 12, 10.4, 7.6};
  for (std::size_t i = 0; i < kPhalanges; ++i)
    bones[kThumb + i] = {i == 0 ? std::size_t{kHand} : kThumb + i - 1, thumb[i], thumb[i + 1], thumbRadii[i],
                         thumbRadii[i + 1]};
  constexpr std::array<std::size_t, kFingers> kParents = {kIndexMetacarpal, kHand, kRingMetacarpal,
                                                          kLittleMetacarpal};
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    const FingerShape& shape = kFingerShapes[finger];
    const double lean = glm::radians(shape.lean);
    dvec3 from = shape.knuckle;
    for (std::size_t joint = 0; joint < kPhalanges; ++joint) {
      // At rest a finger is bent a little.
      const double bend = glm::radians(4.0 + 5.0 * static_cast<double>(joint));
      const dvec3 along(std::sin(lean) * std::cos(bend), std::cos(lean) * std::cos(bend), std::sin(bend));
      const dvec3 to = from + along * shape.lengths[joint];
      bones[phalanx(finger, joint)] = {joint == 0 ? kParents[finger] : phalanx(finger, joint - 1), from, to,
                                       shape.radii[joint], shape.radii[joint + 1]};
      from = to;
    }
  }
  return bones;
}

// Degrees. A finger bends towards the palm and spreads away from the middle one; the thumb's first joint
// turns over the palm, closes towards the index finger, and the others bend.
struct FingerPose {
  double spread, knuckle, middle, tip;
};
struct Pose {
  double bend, tilt, turn;  // of the wrist: to the palm's side, to the thumb's side, about the forearm
  double cup;               // of the palm
  double thumbOver, thumbClose, thumbMiddle, thumbTip;
  std::array<FingerPose, kFingers> fingers;
};
using Angles = std::array<double, 8 + 4 * kFingers>;
static_assert(sizeof(Pose) == sizeof(Angles));

constexpr Pose kOpen = {-4, 0, 0, 0, 0, 0, 4, 6, {{{0, 4, 6, 4}, {0, 3, 6, 4}, {0, 5, 8, 5}, {0, 7, 10, 6}}}};
constexpr Pose kSpread = {
    -12, 0, 0, -4, -10, -14, -6, -10, {{{7, -8, -2, -2}, {1, -8, -2, -2}, {6, -8, -2, -2}, {9, -8, -2, -2}}}};
constexpr Pose kFist = {
    4,  0,  0,
    10, 44, 24,
    34, 58, {{{-12, 82, 100, 62}, {-3, 84, 102, 64}, {-6, 86, 100, 62}, {-14, 86, 96, 58}}}};
constexpr Pose kPoint = {-2, 0,  0,
                         10, 52, 30,
                         36, 52, {{{-9, -2, 4, 3}, {-3, 84, 102, 64}, {-6, 86, 100, 62}, {-14, 86, 96, 58}}}};

Pose waving(double tilt) {
  Pose pose = kSpread;
  pose.tilt = tilt;
  pose.turn = -0.35 * tilt;
  pose.bend = -5;
  for (std::size_t finger = 0; finger < kFingers; ++finger)
    pose.fingers[finger].knuckle = 5 + (tilt > 0 ? 3.0 : -3.0) * (static_cast<double>(finger) - 1.5);
  return pose;
}

// Half way from open to fist: the little finger leads.
Pose closing() {
  Pose pose = kOpen;
  constexpr std::array<double, kFingers> kShare = {0.25, 0.45, 0.68, 0.88};
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    FingerPose& f = pose.fingers[finger];
    const FingerPose& shut = kFist.fingers[finger];
    f = {glm::mix(f.spread, shut.spread, kShare[finger]), glm::mix(f.knuckle, shut.knuckle, kShare[finger]),
         glm::mix(f.middle, shut.middle, kShare[finger]), glm::mix(f.tip, shut.tip, kShare[finger])};
  }
  return pose;
}

// Pointing out of the picture, the wrist bent over.
Pose pointingAhead() {
  Pose pose = kPoint;
  pose.bend = 50;
  pose.turn = 12;
  pose.tilt = 6;
  pose.fingers[0].knuckle = 24;
  return pose;
}

struct KeyFrame {
  double time;
  Pose pose;
};

const std::vector<KeyFrame>& keyFrames() {
  static const std::vector<KeyFrame> frames = {{0.0, kOpen},
                                               {0.9, waving(19)},
                                               {1.7, waving(-15)},
                                               {2.5, waving(19)},
                                               {3.3, waving(-15)},
                                               {4.2, kSpread},
                                               {5.0, kOpen},
                                               {5.7, closing()},
                                               {6.4, kFist},
                                               {7.8, kFist},
                                               {8.5, kPoint},
                                               {9.8, kPoint},
                                               {10.8, pointingAhead()},
                                               {12.4, pointingAhead()},
                                               {13.4, kPoint},
                                               {14.3, kSpread},
                                               {kActLength, kOpen}};
  return frames;
}

// A curve through all key frames whose slopes come from the neighbours (Catmull and Rom), held back where it
// would swing beyond them.
double through(double before, double from, double to, double after, double t) {
  const auto slope = [](double a, double b, double c) {
    const double left = b - a, right = c - b;
    return left * right <= 0 ? 0.0 : 2 * left * right / (left + right);
  };
  const double start = slope(before, from, to), end = slope(from, to, after);
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * from + (t3 - 2 * t2 + t) * start + (3 * t2 - 2 * t3) * to + (t3 - t2) * end;
}

Pose poseAt(double time) {
  const std::vector<KeyFrame>& frames = keyFrames();
  const double at = time - kActLength * std::floor(time / kActLength);
  const std::size_t last = frames.size() - 1;
  std::size_t i = 0;
  while (i + 1 < last && frames[i + 1].time <= at) ++i;
  const double t = (at - frames[i].time) / (frames[i + 1].time - frames[i].time);
  const Pose& before = frames[i == 0 ? last - 1 : i - 1].pose;
  const Pose& after = frames[i + 1 == last ? 1 : i + 2].pose;
  const auto a = std::bit_cast<Angles>(before), b = std::bit_cast<Angles>(frames[i].pose);
  const auto c = std::bit_cast<Angles>(frames[i + 1].pose), d = std::bit_cast<Angles>(after);
  Angles angles{};
  for (std::size_t k = 0; k < angles.size(); ++k) angles[k] = through(a[k], b[k], c[k], d[k], t);
  Pose pose = std::bit_cast<Pose>(angles);
  // A living hand is never quite still.
  pose.bend += 0.8 * std::sin(1.3 * time);
  pose.tilt += 0.7 * std::sin(0.9 * time + 1);
  for (std::size_t finger = 0; finger < kFingers; ++finger)
    pose.fingers[finger].knuckle += 1.1 * std::sin(1.7 * time + 0.8 * static_cast<double>(finger));
  return pose;
}

// The bone's own axes at rest: y along it, z to the palm's side.
dmat4 restFrame(const RestBone& bone, const dvec3& palm) {
  const dvec3 y = glm::normalize(bone.to - bone.from);
  const dvec3 x = glm::normalize(glm::cross(y, palm));
  dmat4 frame(1.0);
  frame[0] = glm::dvec4(x, 0);
  frame[1] = glm::dvec4(y, 0);
  frame[2] = glm::dvec4(glm::cross(x, y), 0);
  frame[3] = glm::dvec4(bone.from, 1);
  return frame;
}

dmat4 turned(double degrees, const dvec3& axis) {
  return glm::rotate(dmat4(1.0), glm::radians(degrees), axis);
}

constexpr dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// The turn of a bone about its beginning, in its own axes.
dmat4 jointTurn(const Pose& pose, std::size_t bone) {
  if (bone == kForearm) return dmat4(1.0);
  if (bone == kHand) return turned(pose.turn, kY) * turned(-pose.tilt, kZ) * turned(pose.bend, kX);
  if (bone == kIndexMetacarpal) return turned(0.25 * pose.cup, kX);
  if (bone == kRingMetacarpal) return turned(0.6 * pose.cup, kX);
  if (bone == kLittleMetacarpal) return turned(pose.cup, kX);
  if (bone == kThumb)  // over the palm, it also leaves it
    return turned(0.27 * pose.thumbOver, kX) * turned(-pose.thumbOver, kY) * turned(pose.thumbClose, kZ);
  if (bone == kThumb + 1) return turned(pose.thumbMiddle, kX);
  if (bone == kThumb + 2) return turned(pose.thumbTip, kX);
  const std::size_t finger = (bone - kFinger) / kPhalanges, joint = (bone - kFinger) % kPhalanges;
  const FingerPose& f = pose.fingers[finger];
  const double outwards = finger < 2 ? -f.spread : f.spread;
  if (joint == 0) return turned(outwards, kZ) * turned(f.knuckle, kX);
  return turned(joint == 1 ? f.middle : f.tip, kX);
}

}  // namespace

const std::array<RestBone, kBones>& restBones() {
  static const std::array<RestBone, kBones> bones = makeRestBones();
  return bones;
}

std::array<glm::dmat4, kBones> boneMatrices(double time) {
  const Pose pose = poseAt(time);
  std::array<dmat4, kBones> matrices;
  for (std::size_t bone = 0; bone < kBones; ++bone) {
    const RestBone& rest = restBones()[bone];
    const bool thumb = bone > kThumb && bone < kFinger;
    // The thumb's root turns in the hand's axes; its other joints bend across the palm.
    const dmat4 frame = bone == kThumb ? glm::translate(dmat4(1.0), rest.from)
                                       : restFrame(rest, thumb ? dvec3(-0.62, 0.30, 0.72) : kZ);
    const dmat4 turn = frame * jointTurn(pose, bone) * glm::inverse(frame);
    matrices[bone] = bone == kForearm ? turn : matrices[rest.parent] * turn;
  }
  return matrices;
}

}  // namespace skinning
