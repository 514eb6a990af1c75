#include "water.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <stdexcept>

#include "caustics.h"
#include "pond.h"
#include "puddles.h"
#include "reflection.h"
#include "refraction.h"
#include "room/context.h"
#include "room/passes.h"
#include "set/draw_atrium.h"
#include "sheet.h"
#include "waves.h"

namespace water {
namespace {

constexpr std::array<std::string_view, 5> kStages = {"room", "refraction", "reflection", "puddles", "final"};

void clear() {
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Integrator integratorNamed(std::string_view name) {
  for (Integrator integrator :
       {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler, Integrator::ImplicitEuler}) {
    if (name == nameOf(integrator)) return integrator;
  }
  throw std::invalid_argument("there is no such integrator");
}

// Moves slowly to and fro before the pool.
room::Camera cameraFor(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(-6.0 + 13.0 * std::sin(turn / 37.0));
  const glm::dvec3 target(0.0, 1.38, -0.9);
  const glm::dvec3 eye =
      target + glm::dvec3(5.7 * std::sin(angle), 0.86 + 0.16 * std::sin(turn / 23.0), 5.7 * std::cos(angle));
  return room::cameraAt(view, eye, target, 54, 0.1, 25.0);
}

class Water final : public room::Demo {
 public:
  void configure(const room::Settings& settings) override;
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void drawFloor(const room::Camera& camera, bool wet);
  void moveWater(double time, const glm::dvec3& eye);
  void drawWater(const room::Camera& camera, bool refraction, bool reflection);

  std::optional<room::FramebufferFunctions> gl_;  // outlives what is made of it
  std::optional<Reflection> reflection_;
  std::optional<Puddles> puddles_;
  std::optional<Atrium> atrium_;
  std::optional<Pond> pond_;  // none: waves
  Sheet sheet_;
  Caustics caustics_;
  Heights heights_;
};

void Water::configure(const room::Settings& settings) {
  if (settings.water == "springs") pond_.emplace(integratorNamed(settings.integrator), settings.stiffness);
}

void Water::setup() {
  gl_.emplace("water");
  reflection_.emplace(*gl_);
  room::requireTextureUnits(kUnits, "water");
  puddles_.emplace(*gl_);
  atrium_.emplace();
  reflection_->render([this](const room::Camera& camera) {
    clear();
    drawAboveFloor(*atrium_, camera);
    drawFloor(camera, false);
    drawPool(*atrium_);
  });
}

void Water::frame(const room::View& view, std::string_view stage) {
  const room::Camera camera = cameraFor(view);
  const bool finished = stage == kStages.back();
  const bool wet = finished || stage == "puddles";
  const bool refraction = finished || stage == "refraction";
  const bool reflection = finished || stage == "reflection";
  if (wet) {
    puddles_->render(camera, [this](const room::Camera& mirrored) {
      clear();
      drawAboveFloor(*atrium_, mirrored);
      drawShaft(*atrium_);
    });
  }
  glViewport(0, 0, view.width, view.height);
  clear();
  drawAboveFloor(*atrium_, camera);
  drawFloor(camera, wet);
  drawPool(*atrium_);
  if (refraction || reflection) {
    moveWater(view.time, camera.eye);
    drawWater(camera, refraction, reflection);
  }
  if (finished) {
    drawLilies(*atrium_, sheet_, camera);
    drawShaft(*atrium_);
  }
  room::resetPasses(kUnits);
}

void Water::drawFloor(const room::Camera& camera, bool wet) {
  room::resetPasses(kUnits);
  if (wet) puddles_->begin(camera);
  for (const Surface& floor : atrium_->floor()) {
    if (wet) puddles_->wet(floor, camera.eye);
    drawLightmapped(floor);
  }
}

void Water::moveWater(double time, const glm::dvec3& eye) {
  if (pond_) {
    pond_->heightsAt(time, heights_);
  } else {
    waveHeights(time, heights_);
  }
  caustics_.update(heights_);
  sheet_.update(heights_, caustics_, eye);
}

// One pass: refraction in unit 0, and over it, by Fresnel's share, reflection in unit 1.
void Water::drawWater(const room::Camera& camera, bool refraction, bool reflection) {
  room::resetPasses(kUnits);
  sheet_.bindPositions();
  if (refraction) useRefraction(sheet_, atrium_->poolTexture());
  if (reflection) {
    glEnableClientState(GL_NORMAL_ARRAY);
    sheet_.bindNormals();
    reflection_->begin(camera.view, refraction);
  }
  sheet_.draw();
  reflection_->end();
}

}  // namespace

std::unique_ptr<room::Demo> makeWater() {
  return std::make_unique<Water>();
}

}  // namespace water
