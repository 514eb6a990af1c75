#include "glaze.h"

#include <EGL/egl.h>

#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "room/noise.h"
#include "room/passes.h"
#include "room/transform.h"
#include "skinning.h"

namespace skinning {
namespace {

using glm::dvec3;

constexpr int kFaceSize = 128;

// A light as a mirror sees it: a soft disc in a direction.
struct Highlight {
  dvec3 direction;  // a unit vector
  double radius;    // radians
  double strength;
};
// A window of four panes, a corner and two edges as seen from the hand.
struct BrightWindow {
  dvec3 corner, across, up;
  double strength;
};

// What a glossy body reflects of the room, as alpha (and as luminance): six faces of a cube map.
std::array<room::Image, 6> highlightFaces(const std::vector<Highlight>& lights, const BrightWindow& window) {
  std::array<room::Image, 6> faces;
  const dvec3 plane = glm::cross(window.across, window.up);
  for (int face = 0; face < 6; ++face) {
    faces[static_cast<std::size_t>(face)] =
        room::generate(kFaceSize, kFaceSize, 2, [&, face](double s, double t, float* out) {
          const dvec3 d = room::cubeDirection(face, s, t);
          // The room itself: a little above, less below.
          double light = 0.05 + 0.05 * d.y;
          for (const Highlight& h : lights) {
            const double angle = std::acos(glm::clamp(glm::dot(d, h.direction), -1.0, 1.0));
            light += h.strength * (1 - room::smoothStep(0.7 * h.radius, 1.35 * h.radius, angle));
            light += 0.16 * h.strength * std::exp(-angle * angle / (9 * h.radius * h.radius));
          }
          const double distance = glm::dot(window.corner, plane) / glm::dot(d, plane);
          if (distance > 0) {
            const dvec3 hit = d * distance - window.corner;
            const double x = glm::dot(hit, window.across) / glm::dot(window.across, window.across);
            const double y = glm::dot(hit, window.up) / glm::dot(window.up, window.up);
            const auto inside = [](double at) {
              return room::smoothStep(-0.03, 0.04, at) * (1 - room::smoothStep(0.96, 1.03, at));
            };
            const auto bar = [](double at) { return room::smoothStep(0.02, 0.06, std::abs(at - 0.5)); };
            light += window.strength * inside(x) * inside(y) * bar(x) * bar(y);
          }
          out[0] = out[1] = static_cast<float>(glm::clamp(light, 0.0, 1.0));
        });
  }
  return faces;
}

// What the hand mirrors: lamp, candles and the window.
std::array<room::Image, 6> mirrored(const Parlour& parlour, const dvec3& middle) {
  std::vector<Highlight> lights = {{glm::normalize(kLamp - middle), 0.12, 0.72}};
  for (const dvec3& candle : parlour.candles())
    lights.push_back({glm::normalize(candle - middle), 0.055, 0.7});
  const BrightWindow window = {kWindowCorner - middle, {kWindowSize.x, 0, 0}, {0, kWindowSize.y, 0}, 0.62};
  return highlightFaces(lights, window);
}

}  // namespace

Glaze::Glaze(const Parlour& parlour, const dvec3& middle) {
  texGeni_ = reinterpret_cast<PFNGLTEXGENIOESPROC>(eglGetProcAddress("glTexGeniOES"));
  highlights_ = room::makeCubeTexture(mirrored(parlour, middle), room::Filter::Linear);
}

void Glaze::begin(std::string_view stage, const room::Texture& base, const glm::dmat4& view) const {
  // What the cube map is looked up by comes in eye coordinates: back to the room's.
  room::loadTextureMatrix(1, glm::dmat4(glm::transpose(glm::dmat3(view))));
  glActiveTexture(GL_TEXTURE1);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  highlights_.bind();
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, stage == "diffuse" ? GL_REPLACE : GL_ADD);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, stage == "specular" ? GL_SRC_ALPHA : GL_SRC_COLOR);
  if (stage == "specular") glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_SRC_ALPHA);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);

  room::useTexture(0, base);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_MODULATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_MODULATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_TEXTURE1);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_ALPHA, GL_TEXTURE);
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);
}

void Glaze::end() const {
  glActiveTexture(GL_TEXTURE0);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
  glActiveTexture(GL_TEXTURE1);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_SRC_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_SRC_COLOR);
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  glDisable(GL_TEXTURE_GEN_STR_OES);
  room::resetPasses(kUnits);
}

void placeLights(const Parlour& parlour, const glm::dmat4& view, double flicker) {
  struct Source {
    glm::vec4 position;
    glm::vec3 color;
    float quadratic;
  };
  const std::vector<glm::dvec3>& candles = parlour.candles();
  const auto steady = static_cast<float>(flicker);
  const std::array<Source, 4> sources = {{
      {{kLamp, 1}, glm::vec3(1.24F, 0.99F, 0.73F) * steady, 0.38F},
      {{candles[0], 1}, glm::vec3(0.62F, 0.38F, 0.17F) * steady, 2.2F},
      {{candles[1], 1}, glm::vec3(0.62F, 0.38F, 0.17F) * steady, 2.2F},
      {{kWindowCorner + glm::dvec3(kWindowSize * 0.5, 0), 1}, glm::vec3(0.30F, 0.42F, 0.72F), 0.0F},
  }};
  room::loadMatrix(view);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const GLenum light = GL_LIGHT0 + static_cast<GLenum>(i);
    const glm::vec4 diffuse(sources[i].color, 1), black(0, 0, 0, 1);
    glEnable(light);
    glLightfv(light, GL_POSITION, glm::value_ptr(sources[i].position));
    glLightfv(light, GL_DIFFUSE, glm::value_ptr(diffuse));
    glLightfv(light, GL_SPECULAR, glm::value_ptr(black));
    glLightf(light, GL_QUADRATIC_ATTENUATION, sources[i].quadratic);
  }
  const glm::vec4 ambient(0.13F, 0.105F, 0.115F, 1), white(1);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, glm::value_ptr(white));
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, glm::value_ptr(white));
}

}  // namespace skinning
