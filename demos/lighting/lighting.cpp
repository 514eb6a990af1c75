#include "lighting.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "bumpmapping.h"
#include "light_vectors.h"
#include "room/camera.h"
#include "room/context.h"
#include "room/passes.h"
#include "set/glow.h"
#include "shadows.h"
#include "specular.h"
#include "spot_mask.h"

namespace lighting {
namespace {

constexpr std::array<std::string_view, 5> kStages = {"bump", "spot", "specular", "shadows", "final"};

struct Terms {
  bool bump = false;
  bool spot = false;
  bool specular = false;
  bool shadows = false;
  bool shadowsAlone() const { return shadows && !bump; }
};

Terms termsOf(std::string_view stage) {
  if (stage == "final") return {true, true, true, true};
  return {stage == "bump", stage == "spot" || stage == "specular", stage == "specular", stage == "shadows"};
}

room::Camera cameraFor(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(7.0 + 13.0 * std::sin(turn / 26.0));
  const glm::dvec3 target(0.12, 1.10, -1.2);
  const glm::dvec3 eye = target + glm::dvec3(4.55 * std::sin(angle), 0.55 + 0.15 * std::sin(turn / 17.0),
                                             4.55 * std::cos(angle));
  return room::cameraAt(view, eye, target, 50, 0.1, 20.0);
}

class Lighting final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void drawBase(const Terms& terms, const glm::dmat4& view) const;
  void addLight(int lightIndex, const Terms& terms, const glm::dmat4& view);

  std::optional<Scene> scene_;
  std::optional<LightVectors> lit_;
  std::optional<SpotMask> spotMask_;
  std::optional<Specular> specular_;  // none without cube maps
  std::optional<Glow> glow_;
};

void Lighting::setup() {
  room::requireTextureUnits(kUnits, "lighting");
  scene_.emplace();
  lit_.emplace(*scene_);
  spotMask_.emplace();
  if (room::hasExtension("GL_OES_texture_cube_map")) specular_.emplace();
  glow_.emplace();
}

void Lighting::frame(const room::View& view, std::string_view stage) {
  const Terms terms = termsOf(stage);
  if (terms.specular && !specular_) room::requireExtension("GL_OES_texture_cube_map", "lighting");
  scene_->animate(view.time);
  const room::Camera camera = cameraFor(view);
  glViewport(0, 0, view.width, view.height);
  room::useCamera(camera);
  drawBase(terms, camera.view);
  for (int i = 0; i < kLights; ++i) addLight(i, terms, camera.view);
  if (terms.bump && terms.spot) glow_->draw(*scene_, camera);
  beginPass();
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Depth, the stencil values of what takes shadows, and the dim light of the room (or what takes its place in
// a single stage).
void Lighting::drawBase(const Terms& terms, const glm::dmat4& view) const {
  beginPass();
  glDepthMask(GL_TRUE);
  glStencilMask(~0U);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClearStencil(0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  for (const Part& part : scene_->parts()) {
    glStencilFunc(GL_ALWAYS, static_cast<GLint>(stencilOf(part.receiver)), ~0U);
    place(part, view);
    part.mesh->bindPositions();
    if (terms.bump) {
      glEnableClientState(GL_COLOR_ARRAY);
      part.mesh->bindColors();
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
      room::setColor(glm::dvec3(!terms.shadowsAlone() ? 0.0 : part.receiver == Receiver::None ? 0.42 : 0.78));
    }
    if (part.material != nullptr && terms.bump) {
      room::useTexture(0, part.material->base);
      room::modulate();
      room::useTexCoords(0, *part.mesh);
    } else {
      glActiveTexture(GL_TEXTURE0);
      glDisable(GL_TEXTURE_2D);
    }
    part.mesh->draw();
  }
}

// The spot into alpha, less the shadows; then what is lit through it.
void Lighting::addLight(int lightIndex, const Terms& terms, const glm::dmat4& view) {
  const Spotlight& light = scene_->lights()[static_cast<std::size_t>(lightIndex)];
  if (!terms.shadowsAlone()) {
    lit_->update(light, terms.spot);
    spotMask_->draw(*lit_, lightIndex, light, view, terms.spot);
  }
  if (terms.shadows) drawShadows(*scene_, lightIndex, view, terms.shadowsAlone());
  // Without its cone a light is everywhere at once.
  if (terms.bump) drawBump(*lit_, light, view, terms.spot ? 1.0 : 0.5);
  if (terms.spot && !terms.bump && !terms.specular) drawSpot(*lit_, light, view);
  if (terms.specular) specular_->draw(*lit_, light, view);
}

}  // namespace

void beginPass() {
  room::resetPasses(kUnits);
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

std::unique_ptr<room::Demo> makeLighting() {
  return std::make_unique<Lighting>();
}

}  // namespace lighting
