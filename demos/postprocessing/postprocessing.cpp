#include "postprocessing.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <string>

#include "bloom.h"
#include "room/passes.h"
#include "room/transform.h"
#include "set/chapel.h"

namespace postprocessing {
namespace {

constexpr std::array<std::string_view, 8> kStages = {"scene", "mask", "128",   "64",
                                                     "32",    "16",   "glare", "final"};
constexpr glm::dvec3 kGlareColor(0.92, 0.84, 0.66);

void enableTexture(int unit, bool enabled) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  if (enabled) {
    glEnable(GL_TEXTURE_2D);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  } else {
    glDisable(GL_TEXTURE_2D);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
}

bool shines(const Part& part) {
  return part.surface == Surface::Glass || part.surface == Surface::Flame || part.surface == Surface::Dust;
}

// From here on what is drawn is added to what lies behind it. The dust comes last.
void addLight() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDepthMask(GL_FALSE);
}

class Postprocessing final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void placeCamera(const room::View& view);
  void beginScene() const;
  void drawScene() const;
  void drawMask() const;
  void drawGlare() const;
  const room::RenderTarget* pictureOf(std::string_view stage) const;
  void place(const Part& part) const { room::loadMatrix(part.swings ? camera_ * lamp_ : camera_); }

  std::optional<room::FramebufferFunctions> gl_;  // outlives what is made of it
  std::optional<Bloom> bloom_;
  std::optional<Chapel> chapel_;
  glm::dmat4 projection_{1.0};
  glm::dmat4 camera_{1.0};
  glm::dmat4 lamp_{1.0};
};

void Postprocessing::setup() {
  gl_.emplace("postprocessing");
  bloom_.emplace(*gl_);
  chapel_.emplace();
}

void Postprocessing::frame(const room::View& view, std::string_view stage) {
  placeCamera(view);
  lamp_ = Chapel::lampAt(view.time);
  const bool finished = stage == kStages.back();
  if (stage != "scene") bloom_->render([this] { drawMask(); });
  glViewport(0, 0, view.width, view.height);
  if (finished || stage == "scene") drawScene();
  if (finished) drawGlare();
  if (const room::RenderTarget* picture = pictureOf(stage)) {
    glColor4f(1, 1, 1, 1);
    drawFullScreen(*picture);
  }
}

// The camera goes to and fro across the nave, so that columns, lamp and cross pass before the windows.
void Postprocessing::placeCamera(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const glm::dvec3 eye(2.55 * std::sin(turn / 48.0 - 0.35), 1.78 + 0.12 * std::sin(turn / 19.0),
                       4.55 + 0.35 * std::cos(turn / 24.0));
  const glm::dvec3 target(0.16 * eye.x, 2.05, -6.0);
  camera_ = glm::lookAt(room::orbited(view, eye, target), target, glm::dvec3(0, 1, 0));
  projection_ =
      glm::perspective(glm::radians(46.0), static_cast<double>(view.width) / view.height, 0.2, 20.0);
}

void Postprocessing::beginScene() const {
  glMatrixMode(GL_PROJECTION);
  room::loadMatrix(projection_);
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glEnableClientState(GL_VERTEX_ARRAY);
}

void Postprocessing::drawScene() const {
  beginScene();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnableClientState(GL_COLOR_ARRAY);
  for (const Part& part : chapel_->parts()) {
    place(part);
    // On the floor unit 0 adds the sun's light to that of the vertices before unit 1 brings the stone.
    const bool floor = part.surface == Surface::Floor;
    const int unit = floor ? 1 : 0;
    enableTexture(1 - unit, floor);
    if (floor) {
      chapel_->sunOnFloor().bind();
      room::combine(GL_ADD, GL_TEXTURE, GL_PREVIOUS);
      part.mesh->bindPositionsAsTexCoords();
      room::loadTextureMatrix(0, Chapel::floorProjection());
    }
    enableTexture(unit, part.texture != nullptr);
    if (part.texture != nullptr) {
      part.texture->bind();
      room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, shines(part) ? 1 : static_cast<float>(kLightScale));
      part.mesh->bindTexCoords();
    }
    if (part.surface == Surface::Dust) addLight();
    part.mesh->bindPositions();
    part.mesh->bindColors();
    part.mesh->draw();
    if (floor) room::loadTextureMatrix(0, glm::dmat4(1.0));
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisableClientState(GL_COLOR_ARRAY);
  enableTexture(1, false);
  enableTexture(0, false);
}

void Postprocessing::drawMask() const {
  beginScene();
  enableTexture(1, false);
  enableTexture(0, false);
  glDisableClientState(GL_COLOR_ARRAY);
  for (const Part& part : chapel_->parts()) {
    if (part.surface == Surface::Dust) continue;
    const GLfloat white = shines(part) ? 1 : 0;
    glColor4f(white, white, white, 1);
    place(part);
    part.mesh->bindPositions();
    part.mesh->draw();
  }
}

void Postprocessing::drawGlare() const {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  glColor4f(kGlareColor.r, kGlareColor.g, kGlareColor.b, 1);
  drawFullScreen(bloom_->glare());
  glDisable(GL_BLEND);
}

const room::RenderTarget* Postprocessing::pictureOf(std::string_view stage) const {
  if (stage == "mask") return &bloom_->mask();
  if (stage == "glare") return &bloom_->glare();
  for (std::size_t i = 0; i < kReductions.size(); ++i) {
    if (stage == std::to_string(kReductions[i].size)) return &bloom_->reduction(i);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<room::Demo> makePostprocessing() {
  return std::make_unique<Postprocessing>();
}

}  // namespace postprocessing
