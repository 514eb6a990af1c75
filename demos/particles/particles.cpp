#include "particles.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "fire.h"
#include "flicker.h"
#include "points.h"
#include "quads.h"
#include "room/camera.h"
#include "room/passes.h"
#include "set/cellar.h"

namespace particles {
namespace {

constexpr std::array<std::string_view, 3> kStages = {"room", "fire", "final"};
constexpr double kFieldOfView = 48;  // degrees, from below to above
constexpr glm::dvec3 kFireBase = kBrazier + glm::dvec3(0, kCoalHeight + 0.01, 0);

room::Camera cameraFor(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(11.0 * std::sin(turn / 31.0 + 0.5));
  const glm::dvec3 target = kBrazier + glm::dvec3(0, 1.12, 0);
  const glm::dvec3 eye =
      target + glm::dvec3(4.0 * std::sin(angle), 0.40 + 0.10 * std::sin(turn / 19.0), 4.0 * std::cos(angle));
  return room::cameraAt(view, eye, target, kFieldOfView, 0.1, 20.0);
}

class Particles final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void configure(const room::Settings& settings) override { settings_ = settings; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void beginAdding() const;
  void drawHalo(const room::Camera& camera, const Flicker& flicker) const;
  void drawFire(const room::View& view, const room::Camera& camera);

  room::Settings settings_;
  std::optional<Cellar> cellar_;
  std::optional<Fire> fire_;
  std::optional<Points> points_;
  std::optional<Quads> quads_;  // instead of points, where the settings say so
  room::Texture flame_;
  ParticleArrays particles_;
};

void Particles::setup() {
  if (settings_.quads) {
    quads_.emplace();
  } else {
    points_.emplace();
  }
  cellar_.emplace();
  fire_.emplace(kFireBase, settings_.particles);
  // Small and soft, so that even sparks of few pixels need no mip levels, which implementations choose
  // differently for points.
  flame_ = room::makeTexture(flameImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE);
}

void Particles::frame(const room::View& view, std::string_view stage) {
  const room::Camera camera = cameraFor(view);
  glViewport(0, 0, view.width, view.height);
  room::resetPasses(kUnits);
  room::useCamera(camera);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Flicker flicker = fire_->flicker(view.time);
  if (stage != "fire") {
    drawWalls(*cellar_, flicker);
    drawFurniture(*cellar_, flicker);
  }
  if (stage != "room") {
    beginAdding();
    if (stage != "fire") drawHalo(camera, flicker);
    drawFire(view, camera);
  }
  room::resetPasses(kUnits);
}

// Everything that is drawn in the flame's texture: premultiplied colors over what is there, hidden by the
// room but not by each other.
void Particles::beginAdding() const {
  room::resetPasses(kUnits);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  room::useTexture(0, flame_);
}

// The air around the fire.
void Particles::drawHalo(const room::Camera& camera, const Flicker& flicker) const {
  glDisable(GL_DEPTH_TEST);
  room::setColor(glm::dvec3(0.30, 0.125, 0.035) * Flicker::lightOf(flicker.strength), 0);
  room::drawBillboard(camera, kFireBase + glm::dvec3(0, 0.35, 0), 3.6 * (0.9 + 0.1 * flicker.strength));
  glEnable(GL_DEPTH_TEST);
}

void Particles::drawFire(const room::View& view, const room::Camera& camera) {
  const double distance = glm::length(glm::dvec3(camera.view * glm::dvec4(kFireBase, 1.0)));
  fire_->evaluate(view.time, sizeScaleFor(view, distance), particles_);
  if (quads_) {
    quads_->draw(particles_, attenuationFor(view), camera, kFieldOfView, view.height);
  } else {
    points_->draw(particles_, attenuationFor(view), camera.view);
  }
}

}  // namespace

std::unique_ptr<room::Demo> makeParticles() {
  return std::make_unique<Particles>();
}

}  // namespace particles
