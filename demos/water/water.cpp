#include "water.h"

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <stdexcept>

#include "pond.h"
#include "room/context.h"
#include "room/framebuffer.h"
#include "room/passes.h"
#include "room/reflection.h"
#include "room/transform.h"
#include "set/atrium.h"
#include "sheet.h"
#include "waves.h"

namespace water {
namespace {

using room::combine;
using room::loadTextureMatrix;
using room::modulate;
using room::setColor;
using room::useTexCoords;
using room::useTexture;

constexpr std::array<std::string_view, 5> kStages = {"room", "refraction", "reflection", "puddles", "final"};
constexpr int kUnits = 3;
constexpr int kCubeSize = 256;
constexpr int kMirrorSize = 512;
constexpr double kFieldOfView = 54;  // degrees, from below to above
constexpr std::array<glm::dvec3, 3> kLilies = {{{-0.75, 0, -0.85}, {0.95, 1.9, 0.25}, {-1.15, 4.1, 0.75}}};

struct Camera {
  glm::dmat4 view{1.0};
  glm::dmat4 projection{1.0};
};

// About the floor.
glm::dmat4 mirrored() {
  return glm::scale(glm::dmat4(1.0), glm::dvec3(1, -1, 1));
}

// How much a puddle reflects: more than in nature where one looks down on it.
float puddleShare(double cosine) {
  const double grazing = 1 - std::clamp(cosine, 0.0, 1.0);
  return static_cast<float>(0.16 + 0.80 * grazing * grazing);
}

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

class Water final : public room::Demo {
 public:
  void configure(const room::Settings& settings) override;
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void renderSurroundings();
  void renderMirror();
  void drawAbove(const Camera& camera);
  void drawLightmapped(const Surface& surface);
  void drawFurniture(const Furniture& piece);
  void drawFloor(bool puddles);
  void drawPool();
  void drawWater(bool refraction, bool reflection);
  void drawLilies();
  void drawShaft();

  std::optional<room::FramebufferFunctions> gl_;  // outlives what is made of it
  std::optional<room::ReflectionMapping> reflection_;
  std::optional<room::CubeTarget> surroundings_;
  std::optional<room::RenderTarget> mirror_;
  std::optional<Atrium> atrium_;
  std::optional<Pond> pond_;  // none: waves
  Sheet sheet_;
  Heights heights_;
  Camera camera_;
  glm::dvec3 eye_{0};
  std::vector<glm::vec4> wet_;  // colors of the floor's vertices
};

void Water::configure(const room::Settings& settings) {
  if (settings.water == "springs") pond_.emplace(integratorNamed(settings.integrator), settings.stiffness);
}

void Water::setup() {
  gl_.emplace("water");
  reflection_.emplace("water");
  room::requireTextureUnits(kUnits, "water");
  surroundings_.emplace(*gl_, kCubeSize);
  mirror_.emplace(*gl_, kMirrorSize, room::RenderTarget::Depth::Bits16);
  atrium_.emplace();
  renderSurroundings();
}

void Water::frame(const room::View& view, std::string_view stage) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(-6.0 + 13.0 * std::sin(turn / 37.0));
  const glm::dvec3 target(0.0, 1.38, -0.9);
  eye_ =
      target + glm::dvec3(5.7 * std::sin(angle), 0.86 + 0.16 * std::sin(turn / 23.0), 5.7 * std::cos(angle));
  eye_ = room::orbited(view, eye_, target);
  camera_.view = glm::lookAt(eye_, target, glm::dvec3(0, 1, 0));
  camera_.projection =
      glm::perspective(glm::radians(kFieldOfView), static_cast<double>(view.width) / view.height, 0.1, 25.0);

  const bool finished = stage == kStages.back();
  const bool puddles = finished || stage == "puddles";
  const bool refraction = finished || stage == "refraction";
  const bool reflection = finished || stage == "reflection";
  if (puddles) renderMirror();
  glViewport(0, 0, view.width, view.height);
  clear();
  drawAbove(camera_);
  drawFloor(puddles);
  drawPool();
  if (refraction || reflection) {
    if (pond_) {
      pond_->heightsAt(view.time, heights_);
    } else {
      waveHeights(view.time, heights_);
    }
    sheet_.update(heights_, eye_);
    drawWater(refraction, reflection);
    if (finished) drawLilies();
  }
  if (finished) drawShaft();
  room::resetPasses(kUnits);
}

// Once, from the middle of the surface, which what is drawn stands still around.
void Water::renderSurroundings() {
  for (int face = 0; face < 6; ++face) {
    surroundings_->bind(face);
    clear();
    const glm::dvec3 middle(kPoolCenter.x, 0.12, kPoolCenter.y);
    camera_ = {room::cubeFaceCamera(face, middle), room::cubeFaceProjection(0.05, 25.0)};
    drawAbove(camera_);
    drawFloor(false);
    drawPool();
  }
  surroundings_->unbind();
}

// All that is over the floor; what is inside of it needs no clip plane, for it is not drawn.
void Water::renderMirror() {
  mirror_->bind();
  clear();
  glFrontFace(GL_CW);
  drawAbove({camera_.view * mirrored(), camera_.projection});
  drawShaft();
  glFrontFace(GL_CCW);
  mirror_->unbind();
}

// The room without its floor; leaves the camera's matrices loaded.
void Water::drawAbove(const Camera& camera) {
  room::resetPasses(kUnits);
  glMatrixMode(GL_PROJECTION);
  room::loadMatrix(camera.projection);
  glMatrixMode(GL_MODELVIEW);
  room::loadMatrix(camera.view);
  for (const Surface& wall : atrium_->walls()) drawLightmapped(wall);
  room::resetPasses(kUnits);
  glEnableClientState(GL_COLOR_ARRAY);
  for (const Furniture& piece : atrium_->furniture()) drawFurniture(piece);
}

// Color = base * 2 * lightmap.
void Water::drawLightmapped(const Surface& surface) {
  useTexture(0, *surface.base);
  modulate();
  useTexCoords(0, *surface.mesh);
  useTexture(1, *surface.lightmap);
  combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
  useTexCoords(1, *surface.mesh, true);
  loadTextureMatrix(1, surface.toLightmap);
  surface.mesh->bindPositions();
  surface.mesh->draw();
}

// Color = base * 2 * light in the vertices.
void Water::drawFurniture(const Furniture& piece) {
  if (piece.twoSided) glDisable(GL_CULL_FACE);
  useTexture(0, *piece.base);
  combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, piece.scale);
  useTexCoords(0, *piece.mesh);
  piece.mesh->bindPositions();
  piece.mesh->bindColors();
  piece.mesh->draw();
  glEnable(GL_CULL_FACE);
}

// With puddles, a third unit mixes in the mirror's picture: the base map's alpha, times the share in the
// vertices', is how much of it.
void Water::drawFloor(bool puddles) {
  room::resetPasses(kUnits);
  if (puddles) {
    glEnableClientState(GL_COLOR_ARRAY);
    glActiveTexture(GL_TEXTURE2);
    glEnable(GL_TEXTURE_2D);
    mirror_->bindTexture();
    combine(GL_INTERPOLATE, GL_TEXTURE, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
    loadTextureMatrix(2, room::biasMatrix() * camera_.projection * camera_.view * mirrored());
  }
  for (const Surface& floor : atrium_->floor()) {
    if (puddles) {
      wet_.clear();
      for (const room::Vertex& v : floor.data.vertices) {
        wet_.emplace_back(1, 1, 1, puddleShare(glm::normalize(eye_ - v.position).y));
      }
      glColorPointer(4, GL_FLOAT, 0, wet_.data());
      useTexCoords(2, *floor.mesh, true);
    }
    drawLightmapped(floor);
  }
}

void Water::drawPool() {
  room::resetPasses(kUnits);
  useTexture(0, atrium_->poolTexture());
  combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
  useTexCoords(0, atrium_->pool());
  atrium_->pool().bindPositions();
  atrium_->pool().draw();
}

// Unit 0: the pool's picture * what the water leaves of its light. Unit 1: the surroundings, for Fresnel's
// share.
void Water::drawWater(bool refraction, bool reflection) {
  room::resetPasses(kUnits);
  sheet_.bindPositions();
  if (refraction) {
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_TEXTURE_2D);
    atrium_->poolTexture().bind();
    combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
    glClientActiveTexture(GL_TEXTURE0);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    sheet_.bindTexCoords();
    glEnableClientState(GL_COLOR_ARRAY);
    sheet_.bindColors();
  }
  if (reflection) {
    glEnableClientState(GL_NORMAL_ARRAY);
    sheet_.bindNormals();
    reflection_->enable(1, *surroundings_, camera_.view);
    combine(refraction ? GL_INTERPOLATE : GL_REPLACE, GL_TEXTURE, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
  }
  sheet_.draw();
  reflection_->disable(1);
}

void Water::drawLilies() {
  room::resetPasses(kUnits);
  glDisable(GL_CULL_FACE);
  glEnableClientState(GL_COLOR_ARRAY);
  for (const glm::dvec3& lily : kLilies) {
    const Sheet::Point point = sheet_.at({lily.x, lily.z});
    glm::dmat4 model = glm::translate(
        glm::dmat4(1.0),
        glm::dvec3(kPoolCenter.x + lily.x, kWaterLevel + point.height + 0.004, kPoolCenter.y + lily.z));
    // It leans with the water.
    model = glm::rotate(model, std::atan2(point.normal.z, point.normal.y), glm::dvec3(1, 0, 0));
    model = glm::rotate(model, -std::atan2(point.normal.x, point.normal.y), glm::dvec3(0, 0, 1));
    room::loadMatrix(camera_.view * glm::rotate(model, lily.y, glm::dvec3(0, 1, 0)));
    for (const auto& [mesh, texture] : {std::pair{&atrium_->lilyLeaves(), &atrium_->leaf()},
                                        std::pair{&atrium_->lilyPetals(), &atrium_->petal()}}) {
      useTexture(0, *texture);
      combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
      useTexCoords(0, *mesh);
      mesh->bindPositions();
      mesh->bindColors();
      mesh->draw();
    }
  }
  room::loadMatrix(camera_.view);
}

// Adds to what is there, and hides nothing.
void Water::drawShaft() {
  room::resetPasses(kUnits);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glEnableClientState(GL_COLOR_ARRAY);
  useTexture(0, atrium_->shaftTexture());
  modulate();
  useTexCoords(0, atrium_->shaft());
  atrium_->shaft().bindPositions();
  atrium_->shaft().bindColors();
  atrium_->shaft().draw();
  room::resetPasses(kUnits);
}

}  // namespace

std::unique_ptr<room::Demo> makeWater() {
  return std::make_unique<Water>();
}

}  // namespace water
