#include "reflect.h"

#include <GLES/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "room/context.h"
#include "room/framebuffer.h"
#include "room/overlay.h"
#include "room/passes.h"
#include "room/reflection.h"
#include "room/transform.h"
#include "set/playroom.h"

namespace reflect {
namespace {

using room::combine;
using room::useTexCoords;
using room::useTexture;

constexpr std::array<std::string_view, 4> kStages = {"scene", "proxy", "faces", "final"};
constexpr std::array<std::string_view, 6> kFaceNames = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
constexpr int kCubeSize = 256;
constexpr float kMirror = 0.82F;  // the reflection's share in the ball's color

enum class Version { Fine, Proxy };

struct Camera {
  glm::dmat4 view;
  glm::dmat4 projection;
};

// Goes around the room, never low.
glm::vec4 lightDirection(double time) {
  const double turn = glm::two_pi<double>() * time / 9.0 + 0.6;
  return {std::cos(turn), 0.85, std::sin(turn), 0};
}

class Reflect final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void renderFaces(double time);
  // Draws what a face sees; returns how many things it does not.
  int drawFace(int face, double time);
  void showFaces(const room::View& view);
  void begin(const Camera& camera, double time);
  void drawThing(const Camera& camera, const Thing& thing, Version version);
  void drawBall(const Camera& camera, bool reflection);
  void drawOverlay(const room::View& view);

  std::optional<room::FramebufferFunctions> gl_;  // outlives what is made of it
  std::optional<room::CubeTarget> surroundings_;
  std::optional<room::ReflectionMapping> reflection_;
  std::optional<room::Overlay> overlay_;
  std::optional<Playroom> playroom_;
  std::unique_ptr<room::Mesh> ball_;
  std::array<int, 6> culled_{};
};

void Reflect::setup() {
  gl_.emplace("reflect");
  reflection_.emplace("reflect");
  surroundings_.emplace(*gl_, kCubeSize);
  overlay_.emplace();
  playroom_.emplace();
  ball_ = std::make_unique<room::Mesh>(room::sphere(kBallRadius, 72, 48));
}

void Reflect::frame(const room::View& view, std::string_view stage) {
  playroom_->animate(view.time);
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(4.0 + 16.0 * std::sin(turn / 33.0));
  const glm::dvec3 target(0.0, 0.60, -0.15);
  const glm::dvec3 eye = target + glm::dvec3(3.55 * std::sin(angle), 1.02 + 0.12 * std::sin(turn / 21.0),
                                             3.55 * std::cos(angle));
  const Camera camera{
      glm::lookAt(room::orbited(view, eye, target), target, glm::dvec3(0, 1, 0)),
      glm::perspective(glm::radians(47.0), static_cast<double>(view.width) / view.height, 0.1, 15.0)};

  glClearColor(0, 0, 0, 1);
  const bool finished = stage == kStages.back();
  if (finished) renderFaces(view.time);
  glViewport(0, 0, view.width, view.height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (stage == "faces") {
    showFaces(view);
  } else {
    const Version version = stage == "proxy" ? Version::Proxy : Version::Fine;
    begin(camera, view.time);
    for (const Thing& thing : playroom_->things()) drawThing(camera, thing, version);
    drawThing(camera, playroom_->stand(), version);
    if (stage != "proxy") drawBall(camera, finished);
  }
  if (finished) drawOverlay(view);
  room::resetPasses(1);
}

void Reflect::renderFaces(double time) {
  for (int face = 0; face < 6; ++face) {
    surroundings_->bind(face);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    culled_[static_cast<std::size_t>(face)] = drawFace(face, time);
  }
  surroundings_->unbind();
}

int Reflect::drawFace(int face, double time) {
  const Camera camera{room::cubeFaceCamera(face, kBallCenter), room::cubeFaceProjection(0.25, 15.0)};
  begin(camera, time);
  int culled = 0;
  for (const Thing& thing : playroom_->things()) {
    if (room::isOutside(thing.bounds, camera.projection * camera.view * thing.model)) {
      ++culled;
    } else {
      drawThing(camera, thing, Version::Proxy);
    }
  }
  return culled;
}

// The six as they are stored, two rows of three.
void Reflect::showFaces(const room::View& view) {
  const int side = std::min(view.width / 3, view.height / 2);
  for (int face = 0; face < 6; ++face) {
    glViewport(face % 3 * side, (1 - face / 3) * side, side, side);
    drawFace(face, view.time);
  }
}

// The camera's projection, and the light where it is in the world.
void Reflect::begin(const Camera& camera, double time) {
  room::resetPasses(1);
  glMatrixMode(GL_PROJECTION);
  room::loadMatrix(camera.projection);
  glMatrixMode(GL_MODELVIEW);
  room::loadMatrix(camera.view);
  constexpr glm::vec4 kDiffuse(1.10F, 1.0F, 0.84F, 1);
  constexpr glm::vec4 kAmbient(0.40F, 0.38F, 0.40F, 1);
  constexpr glm::vec4 kSpecular(0.55F, 0.52F, 0.46F, 1);
  constexpr glm::vec4 kBlack(0, 0, 0, 1);
  glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(lightDirection(time)));
  glLightfv(GL_LIGHT0, GL_DIFFUSE, glm::value_ptr(kDiffuse));
  glLightfv(GL_LIGHT0, GL_SPECULAR, glm::value_ptr(kDiffuse));
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(kAmbient));
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, glm::value_ptr(kSpecular));
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, glm::value_ptr(kBlack));
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
}

// Color = texture * scale * the vertices' color, which holds the light of what stands still and the paint of
// what is lit here.
void Reflect::drawThing(const Camera& camera, const Thing& thing, Version version) {
  const room::Mesh& mesh = version == Version::Fine ? *thing.mesh : *thing.proxy;
  room::loadMatrix(camera.view * thing.model);
  if (thing.vertexLit) {
    glEnable(GL_LIGHTING);
    glEnableClientState(GL_NORMAL_ARRAY);
    mesh.bindNormals();
  } else {
    glDisable(GL_LIGHTING);
    glDisableClientState(GL_NORMAL_ARRAY);
  }
  useTexture(0, *thing.texture);
  combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, thing.scale);
  useTexCoords(0, mesh);
  glEnableClientState(GL_COLOR_ARRAY);
  mesh.bindColors();
  mesh.bindPositions();
  mesh.draw();
}

void Reflect::drawBall(const Camera& camera, bool reflection) {
  room::resetPasses(1);
  room::loadMatrix(glm::translate(camera.view, kBallCenter));
  glEnable(GL_LIGHTING);
  glEnableClientState(GL_NORMAL_ARRAY);
  room::setColor({0.80, 0.72, 0.62});
  if (reflection) {
    reflection_->enable(0, *surroundings_, camera.view);
    combine(GL_INTERPOLATE, GL_TEXTURE, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_CONSTANT);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
    const glm::vec4 share(kMirror);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(share));
  }
  ball_->bindPositions();
  ball_->bindNormals();
  ball_->draw();
  if (reflection) reflection_->disable(0);
}

void Reflect::drawOverlay(const room::View& view) {
  room::resetPasses(1);
  const std::size_t all = playroom_->things().size();
  std::vector<std::string> lines;
  for (std::size_t face = 0; face < kFaceNames.size(); ++face) {
    lines.push_back(fmt::format("{}: {:2} of {} culled", kFaceNames[face], culled_[face], all));
  }
  overlay_->draw(view, lines);
}

}  // namespace

std::unique_ptr<room::Demo> makeReflect() {
  return std::make_unique<Reflect>();
}

}  // namespace reflect
