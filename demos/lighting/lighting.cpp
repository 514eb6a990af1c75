#include "lighting.h"

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <EGL/egl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "light_textures.h"
#include "room/context.h"
#include "room/passes.h"
#include "room/transform.h"
#include "set/scene.h"

namespace lighting {
namespace {

using room::combine;
using room::loadTextureMatrix;
using room::modulate;
using room::setColor;
using room::useTexCoords;
using room::useTexture;

constexpr std::array<std::string_view, 5> kStages = {"bump", "spot", "specular", "shadows", "final"};
constexpr int kUnits = 3;
constexpr double kHighlight = 0.75;  // keeps the brightest light's color below 1

// The stencil byte: one bit a light for "already darkened", and the receiver above them.
constexpr GLuint kShadowBits = (1U << kLights) - 1;
constexpr GLuint stencilOf(Receiver receiver) {
  return static_cast<GLuint>(receiver) << kLights;
}

struct Terms {
  bool bump = false;
  bool spot = false;
  bool specular = false;
  bool shadows = false;
};

Terms termsOf(std::string_view stage) {
  if (stage == "final") return {true, true, true, true};
  return {stage == "bump", stage == "spot" || stage == "specular", stage == "specular", stage == "shadows"};
}

// What every pass starts from: depth tested but not written.
void resetState() {
  room::resetPasses(kUnits);
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

class Lighting final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void drawBase(const Terms& terms);
  void drawMask(int lightIndex, const Terms& terms);
  void drawShadows(int lightIndex, bool alone);
  void drawBump(const Spotlight& light, double gain);
  void drawFlat(const Spotlight& light);
  void drawSpecular(const Spotlight& light);
  void drawGlow();
  void drawHalo(const Spotlight& light);
  void drawBeam(const Spotlight& light);

  void lightVertices(const Spotlight& light);
  void chooseLit(const Spotlight& light, bool spot);
  void place(const Part& part) const { room::loadMatrix(camera_ * part.model); }

  std::optional<Scene> scene_;
  std::array<room::Texture, kLights> falloff_;
  room::Texture ramp_;
  room::Texture highlight_;
  room::Texture glow_;
  PFNGLTEXGENIOESPROC texGeni_ = nullptr;
  glm::dmat4 camera_{1.0};
  glm::dvec3 eye_{0};
  // For the light at hand, which parts it can reach, and a color for each of their vertices: the light vector
  // in tangent space, scaled and biased, and the attenuation in alpha.
  struct Lit {
    const Part* part;
    std::vector<glm::vec4>* colors;
  };
  std::vector<Lit> lit_;
  std::vector<std::vector<glm::vec4>> colors_;
};

void Lighting::setup() {
  room::requireTextureUnits(kUnits, "lighting");
  scene_.emplace();
  const auto falloff = [](const room::Image& image) {
    return room::makeTexture(image, room::Filter::Nearest, GL_CLAMP_TO_EDGE, GL_ALPHA);
  };
  falloff_ = {falloff(bulbFalloff()), falloff(lensFalloff())};
  ramp_ = room::makeTexture(rampImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE, GL_ALPHA);
  if (room::hasExtension("GL_OES_texture_cube_map")) {
    texGeni_ = reinterpret_cast<PFNGLTEXGENIOESPROC>(eglGetProcAddress("glTexGeniOES"));
    highlight_ = room::makeCubeTexture(highlightFaces(), room::Filter::Linear);
  }
  glow_ = room::makeTexture(glowImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE);
  colors_.resize(scene_->parts().size());
}

void Lighting::frame(const room::View& view, std::string_view stage) {
  const Terms terms = termsOf(stage);
  if (terms.specular && texGeni_ == nullptr) room::requireExtension("GL_OES_texture_cube_map", "lighting");
  scene_->animate(view.time);

  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(7.0 + 13.0 * std::sin(turn / 26.0));
  const glm::dvec3 target(0.12, 1.10, -1.2);
  eye_ = target +
         glm::dvec3(4.55 * std::sin(angle), 0.55 + 0.15 * std::sin(turn / 17.0), 4.55 * std::cos(angle));
  eye_ = room::orbited(view, eye_, target);
  camera_ = glm::lookAt(eye_, target, glm::dvec3(0, 1, 0));

  glViewport(0, 0, view.width, view.height);
  glMatrixMode(GL_PROJECTION);
  room::loadMatrix(
      glm::perspective(glm::radians(50.0), static_cast<double>(view.width) / view.height, 0.1, 20.0));
  glMatrixMode(GL_MODELVIEW);

  drawBase(terms);
  for (int i = 0; i < kLights; ++i) {
    const Spotlight& light = scene_->lights()[static_cast<std::size_t>(i)];
    const bool shadowsAlone = terms.shadows && !terms.bump;
    if (!shadowsAlone) drawMask(i, terms);
    if (terms.shadows) drawShadows(i, shadowsAlone);
    // Without its cone a light is everywhere at once.
    if (terms.bump) drawBump(light, terms.spot ? 1.0 : 0.5);
    if (terms.spot && !terms.bump && !terms.specular) drawFlat(light);
    if (terms.specular) drawSpecular(light);
  }
  if (terms.bump && terms.spot) drawGlow();
  resetState();
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Depth, the stencil values of the receivers, and the ambient light (or what takes its place in a single
// stage).
void Lighting::drawBase(const Terms& terms) {
  resetState();
  glDepthMask(GL_TRUE);
  glStencilMask(~0U);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClearStencil(0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  const bool shadowsAlone = terms.shadows && !terms.bump;
  for (const Part& part : scene_->parts()) {
    glStencilFunc(GL_ALWAYS, static_cast<GLint>(stencilOf(part.receiver)), ~0U);
    place(part);
    part.mesh->bindPositions();
    if (terms.bump) {
      glEnableClientState(GL_COLOR_ARRAY);
      part.mesh->bindColors();
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
      setColor(glm::dvec3(!shadowsAlone ? 0.0 : part.receiver == Receiver::None ? 0.42 : 0.78));
    }
    if (part.material != nullptr && terms.bump) {
      useTexture(0, part.material->base);
      modulate();
      useTexCoords(0, *part.mesh);
    } else {
      glActiveTexture(GL_TEXTURE0);
      glDisable(GL_TEXTURE_2D);
    }
    part.mesh->draw();
  }
}

// Parts that shine by themselves are not lit; those outside the cone need no pass at all.
void Lighting::chooseLit(const Spotlight& light, bool spot) {
  lit_.clear();
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const Part& part = scene_->parts()[i];
    if (part.material == nullptr) continue;
    const glm::dvec3 center(part.model * glm::dvec4(part.center, 1.0));
    if (!spot || light.reaches(center, part.radius)) lit_.push_back({&part, &colors_[i]});
  }
}

// The light vector at every vertex, rotated into the vertex's T,B,N frame.
void Lighting::lightVertices(const Spotlight& light) {
  for (const auto& [part, colors] : lit_) {
    if (part->material->space != NormalSpace::Tangent) continue;
    const glm::dvec3 lamp(glm::inverse(part->model) * glm::dvec4(light.position, 1.0));
    colors->clear();
    for (const room::Vertex& v : part->data.vertices) {
      const glm::dvec3 toLight = lamp - v.position;
      const double distance = std::max(glm::length(toLight), 1e-6);
      const glm::dvec3 tangentSpace = glm::dvec3(glm::dot(v.tangent, toLight), glm::dot(v.bitangent, toLight),
                                                 glm::dot(v.normal, toLight)) /
                                      distance;
      // Bumps must not catch light that comes from behind the surface.
      const double front = std::min(tangentSpace.z, glm::dot(v.side, toLight) / distance);
      const double facing = std::clamp(front * 6.0 + 0.5, 0.0, 1.0);
      colors->emplace_back(glm::vec3(tangentSpace * 0.5 + 0.5),
                           static_cast<float>(light.attenuation(distance) * facing));
    }
  }
}

// Destination alpha = attenuation * falloff * ramp, where the ramp is 0 behind the light's near plane.
void Lighting::drawMask(int lightIndex, const Terms& terms) {
  const Spotlight& light = scene_->lights()[static_cast<std::size_t>(lightIndex)];
  chooseLit(light, terms.spot);
  lightVertices(light);
  resetState();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  if (terms.spot) {
    useTexture(0, falloff_[static_cast<std::size_t>(lightIndex)]);
    modulate();
    useTexture(1, ramp_);
    modulate();
  }
  for (const auto& [part, colors] : lit_) {
    place(*part);
    part->mesh->bindPositions();
    if (part->material->space == NormalSpace::Tangent) {
      glEnableClientState(GL_COLOR_ARRAY);
      glColorPointer(4, GL_FLOAT, 0, colors->data());
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
      const glm::dvec3 center(part->model * glm::dvec4(part->center, 1.0));
      setColor(glm::dvec3(1), light.attenuation(glm::distance(center, light.position)));
    }
    if (terms.spot) {
      loadTextureMatrix(0, light.projection() * part->model);
      loadTextureMatrix(1, light.nearPlane() * part->model);
      useTexCoords(0, *part->mesh, true);
      useTexCoords(1, *part->mesh, true);
    }
    part->mesh->draw();
  }
}

// Flattens every caster onto every receiver. The stencil lets only pixels of the receiver pass that this
// light has not darkened yet, so neither depth nor overlap matters.
void Lighting::drawShadows(int lightIndex, bool alone) {
  const Spotlight& light = scene_->lights()[static_cast<std::size_t>(lightIndex)];
  const GLuint bit = 1U << lightIndex;
  resetState();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(bit);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  if (alone) {
    setColor(glm::mix(glm::dvec3(0.30), 1.05 - light.color, 0.45));
  } else {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    setColor(glm::dvec3(1), 0.06);
  }
  for (Receiver receiver : kReceivers) {
    const glm::dvec4 plane = planeOf(receiver);
    if (glm::dot(plane, glm::dvec4(light.position, 1.0)) <= 0) continue;
    glStencilFunc(GL_EQUAL, static_cast<GLint>(stencilOf(receiver)), (~0U & ~kShadowBits) | bit);
    const glm::dmat4 flatten = camera_ * room::planarShadow(plane, light.position);
    for (const Part& part : scene_->parts()) {
      if ((part.castsFor & bit) == 0) continue;
      room::loadMatrix(flatten * part.model);
      part.outline().bindPositions();
      part.outline().draw();
    }
  }
  glStencilMask(~0U);
}

// color += N.L * base * light color * destination alpha. The scales of units 1 and 2 make up for the constant
// color, which ends at 1, and for what attenuation takes.
void Lighting::drawBump(const Spotlight& light, double gain) {
  resetState();
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ONE);
  const glm::vec4 color(light.color * (0.5 * gain), 1.0);
  for (const auto& [part, colors] : lit_) {
    place(*part);
    useTexture(0, part->material->normal);
    combine(GL_DOT3_RGB, GL_TEXTURE, GL_PRIMARY_COLOR);
    useTexture(1, part->material->base);
    combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 2);
    useTexture(2, part->material->base);
    combine(GL_MODULATE, GL_PREVIOUS, GL_CONSTANT, 2);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(color));
    part->mesh->bindPositions();
    for (int unit = 0; unit < kUnits; ++unit) useTexCoords(unit, *part->mesh);
    if (part->material->space == NormalSpace::Tangent) {
      glEnableClientState(GL_COLOR_ARRAY);
      glColorPointer(4, GL_FLOAT, 0, colors->data());
    } else {
      // One light vector for the whole object, in the space of its normal map.
      glDisableClientState(GL_COLOR_ARRAY);
      const glm::dvec3 lamp(glm::inverse(part->model) * glm::dvec4(light.position, 1.0));
      setColor(glm::normalize(lamp - part->center) * 0.5 + 0.5);
    }
    part->mesh->draw();
  }
}

// The spot by itself, on white.
void Lighting::drawFlat(const Spotlight& light) {
  resetState();
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ONE);
  setColor(light.color * 0.5);
  for (const Lit& lit : lit_) {
    place(*lit.part);
    lit.part->mesh->bindPositions();
    lit.part->mesh->draw();
  }
}

// The cube map holds a highlight about its +Z axis, drawn out along y; the texture matrix turns the light's
// direction and the object's upright axis there.
void Lighting::drawSpecular(const Spotlight& light) {
  resetState();
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ONE);
  glEnableClientState(GL_NORMAL_ARRAY);
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  highlight_.bind();
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
  modulate();
  for (const Lit& lit : lit_) {
    const Part& part = *lit.part;
    if (part.shine <= 0) continue;
    place(part);
    const glm::dvec3 center(part.model * glm::dvec4(part.center, 1.0));
    const glm::dvec3 toLight = glm::normalize(glm::dmat3(camera_) * (light.position - center));
    loadTextureMatrix(0, room::rotationToAxes(toLight, glm::dmat3(camera_) * glm::dvec3(part.model[1])));
    useTexture(1, part.material->gloss);
    combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 4);
    useTexCoords(1, *part.mesh);
    part.mesh->bindPositions();
    part.mesh->bindNormals();
    setColor(light.color * (kHighlight * part.shine));
    part.mesh->draw();
  }
  glActiveTexture(GL_TEXTURE0);
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  glDisable(GL_TEXTURE_GEN_STR_OES);
}

// The air around the lamps, as far as its dust shows.
void Lighting::drawGlow() {
  resetState();
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  room::loadMatrix(camera_);
  for (const Spotlight& light : scene_->lights()) {
    if (light.beam > 0) drawBeam(light);
  }
  useTexture(0, glow_);
  modulate();
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  for (const Spotlight& light : scene_->lights()) drawHalo(light);
}

// A disc at the lamp that faces the camera.
void Lighting::drawHalo(const Spotlight& light) {
  constexpr std::array<GLfloat, 8> kCorners = {0, 0, 1, 0, 0, 1, 1, 1};
  constexpr double kSize = 1.3;
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(camera_));
  std::array<glm::vec3, 4> quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 offset = kSize * glm::dvec2(kCorners[2 * i] - 0.5, kCorners[2 * i + 1] - 0.5);
    quad[i] = light.position + toWorld * glm::dvec3(offset, 0.06);
  }
  const double facing = glm::dot(light.direction, glm::normalize(eye_ - light.position));
  setColor(light.color * (0.25 + 0.45 * std::max(facing, 0.0)));
  glTexCoordPointer(2, GL_FLOAT, 0, kCorners.data());
  glVertexPointer(3, GL_FLOAT, 0, quad.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

// The shell of the light's cone. It fades where it is seen edge-on, as there is least air behind it, and with
// distance.
void Lighting::drawBeam(const Spotlight& light) {
  constexpr int kSides = 64;
  constexpr std::size_t kPoints = 2 * (kSides + 1);
  constexpr int kRings = 16;
  constexpr double kLength = 4.2;
  const glm::dvec3 side = glm::normalize(glm::cross(light.direction, light.up));
  const glm::dvec3 other = glm::cross(side, light.direction);
  const double slope = std::tan(light.halfAngle * 0.92);
  glEnableClientState(GL_COLOR_ARRAY);
  std::array<glm::vec3, kPoints> points;
  std::array<glm::vec4, kPoints> colors;
  glVertexPointer(3, GL_FLOAT, 0, points.data());
  glColorPointer(4, GL_FLOAT, 0, colors.data());
  for (int ring = 0; ring < kRings; ++ring) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto corner = static_cast<double>(i / 2);
      const double along = kLength * (ring + static_cast<double>(i % 2)) / kRings;
      const double angle = glm::two_pi<double>() * corner / kSides;
      const glm::dvec3 out = side * std::cos(angle) + other * std::sin(angle);
      const glm::dvec3 point = light.position + light.direction * along + out * (slope * along);
      const glm::dvec3 normal = glm::normalize(out - light.direction * slope);
      const double facing = glm::dot(normal, glm::normalize(eye_ - point));
      const double fade = 1 - along / kLength;
      points[i] = point;
      colors[i] = glm::vec4(light.color * (light.beam * fade * fade * facing * facing), 1.0);
    }
    glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(kPoints));
  }
  glDisableClientState(GL_COLOR_ARRAY);
}

}  // namespace

std::unique_ptr<room::Demo> makeLighting() {
  return std::make_unique<Lighting>();
}

}  // namespace lighting
