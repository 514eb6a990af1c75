#include "skinning.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <string>

#include "glaze.h"
#include "hand_shadows.h"
#include "room/context.h"
#include "room/noise.h"
#include "room/passes.h"
#include "room/transform.h"
#include "set/draw_parlour.h"
#include "set/hand_textures.h"
#include "skin.h"

namespace skinning {
namespace {

constexpr std::array<std::string_view, 6> kStages = {"parlour",  "bones",   "diffuse",
                                                     "specular", "shadows", "final"};
constexpr double kScale = 1.75e-3;  // metres of a millimetre of the hand
constexpr double kForearm = 108;    // millimetres of it that stand over the plinth
constexpr glm::dvec3 kWrist{0, kTableTop + kPlinthHeight + kForearm* kScale, 0};

// What the candles leave of the light at a time.
double flickerAt(double time) {
  return 0.955 + 0.045 * room::noise(time * 2.3 + 100, 0.5, 4096, 2, 1001) +
         0.030 * room::noise(time * 6.1 + 100, 0.5, 4096, 2, 1002);
}

room::Camera cameraFor(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(7.0 + 9.0 * std::sin(turn / 37.0));
  const glm::dvec3 target(0.035, 1.045, 0);
  const glm::dvec3 eye = target + glm::dvec3(1.40 * std::sin(angle), 0.20 + 0.03 * std::sin(turn / 23.0),
                                             1.40 * std::cos(angle));
  return room::cameraAt(view, eye, target, 41, 0.1, 12.0);
}

class Skinning final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void configure(const room::Settings& settings) override { who_ = settings.skin; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void drawHand(std::string_view stage, const glm::dmat4& view, double flicker) const;
  void drawBall(std::string_view stage, const glm::dmat4& view) const;

  std::string who_ = "any";
  std::optional<Skin> skin_;
  std::optional<Parlour> parlour_;
  std::optional<Glaze> glaze_;
  std::optional<Halos> halos_;
  room::Texture handBase_;
};

void Skinning::setup() {
  room::requireExtension("GL_OES_texture_cube_map", "skinning");
  room::requireExtension("GL_OES_texture_env_crossbar", "skinning");
  skin_.emplace(who_, kScale);
  parlour_.emplace();
  glaze_.emplace(*parlour_, kWrist + glm::dvec3(0, 0.12, 0));
  halos_.emplace();
  handBase_ = room::makeTexture(handBase(), room::Filter::Mipmapped, GL_CLAMP_TO_EDGE);
}

void Skinning::frame(const room::View& view, std::string_view stage) {
  const double flicker = flickerAt(view.time);
  const room::Camera camera = cameraFor(view);
  room::resetPasses(kUnits);
  glClearColor(0, 0, 0, 1);
  glClearStencil(0);
  glStencilMask(~0U);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glViewport(0, 0, view.width, view.height);
  room::useCamera(camera);
  skin_->pose(boneMatrices(view.time), glm::translate(glm::dmat4(1.0), kWrist));
  const bool whole = stage == "final", alone = stage == "bones" || stage == "diffuse" || stage == "specular";
  if (!alone) drawParlour(*parlour_, flicker);
  if (whole || stage == "shadows") drawShadows(*skin_, camera.view);
  if (whole || alone) drawHand(stage, camera.view, flicker);
  if (whole) {
    drawBall(stage, camera.view);
    halos_->draw(*parlour_, camera, flicker);
  }
  room::resetPasses(kUnits);
}

void Skinning::drawHand(std::string_view stage, const glm::dmat4& view, double flicker) const {
  placeLights(*parlour_, view, flicker);
  if (stage == "bones") {
    glEnable(GL_COLOR_MATERIAL);
  } else {
    glaze_->begin(stage, handBase_, view);
  }
  glEnable(GL_LIGHTING);
  skin_->begin(view);
  if (stage == "bones") skin_->showBones();
  skin_->draw();
  skin_->end();
  glDisable(GL_COLOR_MATERIAL);
  glDisable(GL_LIGHTING);
  room::loadMatrix(view);
  glaze_->end();
}

// Its light is baked into its vertices.
void Skinning::drawBall(std::string_view stage, const glm::dmat4& view) const {
  glaze_->begin(stage, parlour_->ballBase(), view);
  const room::Mesh& ball = parlour_->ball();
  glEnableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  room::useTexCoords(0, ball);
  ball.bindPositions();
  ball.bindNormals();
  ball.bindColors();
  ball.draw();
  glaze_->end();
}

}  // namespace

std::unique_ptr<room::Demo> makeSkinning() {
  return std::make_unique<Skinning>();
}

}  // namespace skinning
