#include "fire.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "room/noise.h"

namespace particles {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

constexpr double kEmitterRadius = 0.27;  // metres
constexpr int kUsualCount = 5000;        // what the colors are meant for

// Of every 100 particles; the rest are flames.
constexpr int kSmokeShare = 7;
constexpr int kEmberShare = 4;

enum Purpose : std::uint32_t { kLife = 700, kPhase, kRadius, kAngle, kSpeed, kStartSize, kEndSize, kSway };

double random(int index, int cycle, Purpose purpose) {
  return room::hash(index, cycle, purpose);
}

// Bell-shaped about the middle, cut off at the ends.
double clampedRandom(int index, int cycle, Purpose purpose, double low, double high) {
  const double sum = random(index, cycle, purpose) + random(index, cycle + 0x10000, purpose) +
                     random(index, cycle + 0x20000, purpose);
  return std::clamp(glm::mix(low, high, (sum / 3 - 0.5) * 1.6 + 0.5), low, high);
}

}  // namespace

void ParticleArrays::resize(std::size_t count) {
  positions.resize(count);
  colors.resize(count);
  sizes.resize(count);
}

Fire::Fire(dvec3 base, int count)
    : base_(base),
      count_(count),
      gain_(std::clamp(static_cast<double>(kUsualCount) / std::max(count, 1), 0.25, 4.0)) {}

Flicker Fire::flicker(double time) const {
  const double slow = noise_.at(time * 1.9, 0);
  const double fast = noise_.at(time * 6.7, 1);
  const double strength = std::clamp(0.84 + 0.13 * slow + 0.07 * fast, 0.0, 1.0);
  return {strength, {noise_.at(time * 1.3, 2), 0, noise_.at(time * 1.3, 3)}};
}

// Metres that the air has moved sideways, a metre above the fire: gusts travel upwards.
dvec2 Fire::wind(double time, double height) const {
  const double at = time * 1.5 - height * 1.1;
  return {0.20 * noise_.at(at, 2) + 0.08 * noise_.at(at * 2.7, 4),
          0.20 * noise_.at(at, 3) + 0.08 * noise_.at(at * 2.7, 5)};
}

void Fire::evaluate(double time, double sizeScale, ParticleArrays& out) const {
  out.resize(static_cast<std::size_t>(count_));
  // Drawn in this order: smoke, flames, embers.
  const int smokeEnd = count_ * kSmokeShare / 100;
  const int flameEnd = count_ - count_ * kEmberShare / 100;
  for (int i = 0; i < count_; ++i) {
    const bool isSmoke = i < smokeEnd;
    const bool isFlame = !isSmoke && i < flameEnd;
    const double shortest = isFlame ? 0.45 : isSmoke ? 2.2 : 1.2;
    const double life = shortest * (1 + random(i, 0, kLife));
    const double lives = time / life + random(i, 0, kPhase);
    const double age = room::fractionOf(lives);
    const int cycle = static_cast<int>(std::fmod(std::floor(lives), 65536.0));
    const Particle p = isFlame   ? flame(i, cycle, age, time, life)
                       : isSmoke ? smoke(i, cycle, age, time)
                                 : ember(i, cycle, age, time);
    const auto at = static_cast<std::size_t>(i);
    out.positions[at] = base_ + p.position;
    out.colors[at] = p.color;
    out.sizes[at] = static_cast<float>(p.size * sizeScale);
  }
}

// Born on a disc, drawn to the middle as it rises. Neighbours that are born together rise together, so that
// the flames have tongues.
Fire::Particle Fire::flame(int index, int cycle, double age, double time, double life) const {
  const double outward = std::sqrt(random(index, cycle, kRadius));
  const double angle = glm::two_pi<double>() * random(index, cycle, kAngle);
  const dvec2 direction(std::cos(angle), std::sin(angle));
  const double birth = time - age * life;
  const double tongue = noise_.at(birth * 2.3 + std::floor(angle * 1.3) * 9.7, 6);
  const double climb = (1.15 - 0.62 * outward) * (1 + 0.55 * tongue) *
                       (0.75 + 0.5 * random(index, cycle, kSpeed)) * life / 0.46;
  const double height = climb * age * (1.25 - 0.25 * age);
  const dvec2 middle = dvec2(0.35 * noise_.at(std::floor(angle * 1.3) * 5.3, 7), 0) * kEmitterRadius;
  const double narrow = 1 - 0.85 * std::pow(age, 0.8);
  dvec2 ground = direction * (outward * kEmitterRadius * narrow) + middle * (1 - narrow);
  const double loose = std::min(height * height * 1.6, height);
  ground += wind(time, height) * loose;
  const double curl = random(index, cycle, kSway) * NoiseTable::kCells;
  ground += 0.13 * height * dvec2(noise_.at(curl + age * 1.6, 4), noise_.at(curl + age * 1.6, 5));

  const double start = clampedRandom(index, cycle, kStartSize, 30, 66);
  const double end = clampedRandom(index, cycle, kEndSize, 6, 16);
  const double glow = room::smoothStep(0, 0.10, age) * std::pow(1 - age, 1.15);
  const dvec3 color =
      age < 0.35 ? glm::mix(dvec3(0.060, 0.034, 0.0120), dvec3(0.068, 0.0240, 0.0035), age / 0.35)
                 : glm::mix(dvec3(0.068, 0.0240, 0.0035), dvec3(0.070, 0.0115, 0.0015), (age - 0.35) / 0.65);
  return {{ground.x, height, ground.y}, dvec4(color * (glow * gain_), 0), glm::mix(start, end, age)};
}

// Sparks that the hot air carries off.
Fire::Particle Fire::ember(int index, int cycle, double age, double time) const {
  const double outward = std::sqrt(random(index, cycle, kRadius)) * kEmitterRadius;
  const double angle = glm::two_pi<double>() * random(index, cycle, kAngle);
  const double height = (0.7 + 1.5 * random(index, cycle, kSpeed)) * age * (1.3 - 0.3 * age);
  const double curl = random(index, cycle, kSway) * NoiseTable::kCells;
  const double drift = age * (0.25 + 0.35 * height);
  const dvec2 ground = outward * dvec2(std::cos(angle), std::sin(angle)) + wind(time, height) * height * 0.7 +
                       drift * dvec2(noise_.at(curl + age * 3.1, 4), noise_.at(curl + age * 3.1, 5));
  const double twinkle = 0.65 + 0.35 * noise_.at(curl + time * 9, 1);
  // Most go out soon.
  const double left = std::max(1 - age * (0.8 + 1.8 * random(index, cycle, kEndSize)), 0.0);
  const double start = clampedRandom(index, cycle, kStartSize, 6, 14);
  return {{ground.x, height, ground.y},
          dvec4(dvec3(1.0, 0.42, 0.10) * (twinkle * std::sqrt(left)), 0),
          glm::mix(start, 5.0, age)};
}

// Grows instead of shrinking, and hides a little of what is behind.
Fire::Particle Fire::smoke(int index, int cycle, double age, double time) const {
  const double outward = std::sqrt(random(index, cycle, kRadius)) * kEmitterRadius * 0.6;
  const double angle = glm::two_pi<double>() * random(index, cycle, kAngle);
  const double height = 0.45 + 1.75 * age * (0.8 + 0.4 * random(index, cycle, kSpeed));
  const double curl = random(index, cycle, kSway) * NoiseTable::kCells;
  const dvec2 ground = outward * dvec2(std::cos(angle), std::sin(angle)) +
                       wind(time * 0.6, height) * (0.9 * height) +
                       0.45 * age * dvec2(noise_.at(curl + age, 4), noise_.at(curl + age, 5));
  const double density = 0.035 * room::smoothStep(0.1, 0.4, age) * (1 - age) * std::min(gain_, 1.0);
  // Lit from below.
  const dvec3 lit = glm::mix(dvec3(0.75, 0.42, 0.22), dvec3(0.22, 0.19, 0.18), std::min(height / 1.8, 1.0));
  const double start = clampedRandom(index, cycle, kStartSize, 60, 100);
  const double end = clampedRandom(index, cycle, kEndSize, 150, 260);
  return {{ground.x, height, ground.y}, dvec4(lit * density, density), glm::mix(start, end, age)};
}

room::Image flameImage() {
  constexpr int kSize = 32;
  return room::generate(kSize, kSize, 2, [](double u, double v, float* out) {
    const double x = 2 * u - 1;
    const double y = 2 * v - 1;
    const double ragged = 0.16 * room::fractalNoise(u, v, 3, 3, 3, 650);
    const double edge = 1 - room::smoothStep(0.80, 0.97, std::hypot(x, y));
    const double soft = std::max(1 - std::hypot(x, y) + ragged, 0.0);
    out[0] = static_cast<float>(std::min(soft * soft * (3 - 2 * soft), 1.0) * edge);
    out[1] = out[0];
  });
}

}  // namespace particles
