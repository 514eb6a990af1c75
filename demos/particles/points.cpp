#include "points.h"

#include <GLES/glext.h>

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "particles.h"
#include "room/context.h"
#include "room/passes.h"

namespace particles {
namespace {

constexpr double kVgaHeight = 480;

// Whether sizes from the array are attenuated, as OES_point_size_array wants it. Draws a point of 16 pixels,
// less half, into the corner of the surface.
bool attenuatesArray() {
  constexpr GLsizei kSide = 16;
  constexpr std::array<GLfloat, 2> kMiddle = {0, 0};
  constexpr GLfloat kSize = kSide;
  constexpr std::array<GLfloat, 3> kHalf = {4, 0, 0};
  room::resetPasses(kUnits);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glViewport(0, 0, kSide, kSide);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, kHalf.data());
  glEnableClientState(GL_POINT_SIZE_ARRAY_OES);
  glPointSizePointerOES(GL_FLOAT, 0, &kSize);
  glVertexPointer(2, GL_FLOAT, 0, kMiddle.data());
  room::setColor(glm::dvec3(1));
  glDrawArrays(GL_POINTS, 0, 1);
  glDisableClientState(GL_POINT_SIZE_ARRAY_OES);
  std::array<std::array<GLubyte, 4>, kSide> row{};
  glReadPixels(0, kSide / 2, kSide, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
  return row[6][0] > 127 && row[2][0] < 128;
}

}  // namespace

double Attenuation::at(double distance) const {
  return 1 / std::sqrt(a + b * distance + c * distance * distance);
}

Attenuation attenuationFor(const room::View& view) {
  const double scale = view.height / kVgaHeight;
  return {scale * scale, 0, scale * 0.15};
}

double sizeScaleFor(const room::View& view, double distance) {
  const Attenuation vga{1, 0, 0.15};
  return view.height / kVgaHeight * vga.at(distance) / attenuationFor(view).at(distance);
}

std::array<GLfloat, 2> pointSizeRange() {
  std::array<GLfloat, 2> range{1, 1};
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range.data());
  return range;
}

Points::Points() : sizeRange_(pointSizeRange()) {
  if (!room::hasExtension("GL_OES_point_sprite") || !room::hasExtension("GL_OES_point_size_array")) {
    throw std::runtime_error(
        "the fire needs GL_OES_point_sprite and GL_OES_point_size_array, which this implementation does not "
        "have; "
        "--quads does without");
  }
  attenuatesArray_ = attenuatesArray();
}

void Points::draw(ParticleArrays& particles, const Attenuation& attenuation, const glm::dmat4& view) const {
  glm::vec3 coefficients(attenuation.a, attenuation.b, attenuation.c);
  if (!attenuatesArray_) {
    for (std::size_t i = 0; i < particles.sizes.size(); ++i) {
      const glm::dvec3 eye(view * glm::dvec4(particles.positions[i], 1.0));
      particles.sizes[i] = static_cast<float>(particles.sizes[i] * attenuation.at(glm::length(eye)));
    }
    coefficients = {1, 0, 0};
  }
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, glm::value_ptr(coefficients));
  glPointParameterf(GL_POINT_SIZE_MIN, sizeRange_[0]);
  glPointParameterf(GL_POINT_SIZE_MAX, sizeRange_[1]);
  glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 0);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glEnableClientState(GL_COLOR_ARRAY);
  glEnableClientState(GL_POINT_SIZE_ARRAY_OES);
  glVertexPointer(3, GL_FLOAT, 0, particles.positions.data());
  glColorPointer(4, GL_FLOAT, 0, particles.colors.data());
  glPointSizePointerOES(GL_FLOAT, 0, particles.sizes.data());
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(particles.positions.size()));
  glDisableClientState(GL_POINT_SIZE_ARRAY_OES);
  glDisableClientState(GL_COLOR_ARRAY);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_FALSE);
  glDisable(GL_POINT_SPRITE_OES);
}

}  // namespace particles
