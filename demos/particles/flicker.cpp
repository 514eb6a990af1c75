#include "flicker.h"

#include <GLES/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "particles.h"
#include "room/noise.h"
#include "room/passes.h"

namespace particles {
namespace {

constexpr int kTexelsPerCell = 8;

}  // namespace

NoiseTable::NoiseTable()
    : image_(room::generate(kCells * kTexelsPerCell, kRows, 1, [](double u, double v, float* out) {
        const int row = static_cast<int>(v * kRows);
        *out = static_cast<float>(1.7 * room::noise(u * kCells, row + 0.5, kCells, kRows, 640));
      })) {}

double NoiseTable::at(double x, int row) const {
  constexpr int kWidth = kCells * kTexelsPerCell;
  const double texel = room::fractionOf(x / kCells) * kWidth - 0.5;
  const double floor = std::floor(texel);
  const int left = static_cast<int>(floor + kWidth) % kWidth;
  const auto* values = static_cast<const float*>(image_.pixeladdr(0, row));
  return glm::mix<double>(values[left], values[(left + 1) % kWidth], texel - floor);
}

glm::dvec3 Flicker::lightOf(double strength) {
  return {strength, std::pow(strength, 1.12), std::pow(strength, 1.25)};
}

void drawWalls(const Cellar& cellar, const Flicker& flicker) {
  room::resetPasses(kUnits);
  for (const Wall& wall : cellar.walls()) {
    room::useTexture(0, *wall.base);
    room::modulate();
    room::useTexCoords(0, *wall.mesh);
    room::useTexture(1, wall.lightmap);
    room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 2);
    room::useTexCoords(1, *wall.mesh, true);
    room::loadTextureMatrix(1, wall.toLightmap);
    // Flames that lean to a wall light it more.
    const double leaning = 1 - 0.10 * glm::dot(flicker.lean, wall.normal);
    room::setColor(Flicker::lightOf(std::min(flicker.strength * leaning, 1.0)));
    wall.mesh->bindPositions();
    wall.mesh->draw();
  }
}

void drawFurniture(const Cellar& cellar, const Flicker& flicker) {
  room::resetPasses(kUnits);
  glEnableClientState(GL_COLOR_ARRAY);
  const glm::vec4 strength(Flicker::lightOf(flicker.strength), 1.0);
  for (const Furniture& piece : cellar.furniture()) {
    room::useTexture(0, *piece.base);
    room::modulate();
    room::useTexCoords(0, *piece.mesh);
    room::useTexture(1, *piece.base);
    room::combine(GL_MODULATE, GL_PREVIOUS, GL_CONSTANT, piece.glows ? 4 : 2);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(strength));
    piece.mesh->bindPositions();
    piece.mesh->bindColors();
    piece.mesh->draw();
  }
}

}  // namespace particles
