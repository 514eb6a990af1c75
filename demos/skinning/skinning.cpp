#include "skinning.h"

#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <string>

#include "room/context.h"
#include "room/noise.h"
#include "room/passes.h"
#include "room/transform.h"
#include "set/hand_textures.h"
#include "set/parlour.h"
#include "skin.h"

namespace skinning {
namespace {

using room::combine;
using room::loadTextureMatrix;
using room::modulate;
using room::setColor;
using room::useTexCoords;
using room::useTexture;

constexpr std::array<std::string_view, 6> kStages = {"parlour",  "bones",   "diffuse",
                                                     "specular", "shadows", "final"};
constexpr double kScale = 1.75e-3;  // metres of a millimetre of the hand
constexpr double kForearm = 108;    // millimetres of it that stand over the plinth
constexpr glm::dvec3 kWrist{0, kTableTop + kPlinthHeight + kForearm* kScale, 0};

// The lamp's flame as a few places that throw a shadow each.
constexpr std::array<glm::dvec3, 4> kFlames = {
    glm::dvec3(-0.022, 0.004, 0.0), glm::dvec3(0.018, 0.020, 0.010), glm::dvec3(0.004, -0.022, -0.012),
    glm::dvec3(0.002, 0.002, 0.024)};
// Stencil: a bit for what takes a shadow, and one for each place that has thrown its own.
constexpr GLuint kTableBit = 0x80, kWallBit = 0x40;

// What the candles leave of the light at a time.
double flickerAt(double time) {
  return 0.955 + 0.045 * room::noise(time * 2.3 + 100, 0.5, 4096, 2, 1001) +
         0.030 * room::noise(time * 6.1 + 100, 0.5, 4096, 2, 1002);
}

class Skinning final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void configure(const room::Settings& settings) override { who_ = settings.skin; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void lookFrom(const room::View& view);
  void drawParlour(double flicker) const;
  void drawShadows() const;
  void drawShadow(glm::dvec4 plane, GLuint receiver, const glm::dvec3& light, GLuint mark) const;
  void placeLights(double flicker) const;
  void useGlazing(std::string_view stage, const room::Texture& base) const;
  void endGlazing() const;
  void drawHand(std::string_view stage, double flicker) const;
  void drawBall(std::string_view stage) const;
  void drawHalos(double flicker) const;

  std::string who_ = "any";
  std::optional<Parlour> parlour_;
  std::optional<Skin> skin_;
  room::Texture handBase_, highlights_, halo_;
  glm::dmat4 camera_{1.0};
};

// What the hand mirrors: lamp, candles and the window, from its middle.
std::array<room::Image, 6> mirrored(const Parlour& parlour) {
  const glm::dvec3 middle = kWrist + glm::dvec3(0, 0.12, 0);
  std::vector<Highlight> lights = {{glm::normalize(kLamp - middle), 0.12, 0.72}};
  for (const glm::dvec3& candle : parlour.candles())
    lights.push_back({glm::normalize(candle - middle), 0.055, 0.7});
  const BrightWindow window = {kWindowCorner - middle, {kWindowSize.x, 0, 0}, {0, kWindowSize.y, 0}, 0.62};
  return highlightFaces(lights, window);
}

void Skinning::setup() {
  room::requireExtension("GL_OES_texture_cube_map", "skinning");
  room::requireExtension("GL_OES_texture_env_crossbar", "skinning");
  skin_.emplace(who_, kScale);
  parlour_.emplace();
  handBase_ = room::makeTexture(handBase(), room::Filter::Mipmapped, GL_CLAMP_TO_EDGE);
  highlights_ = room::makeCubeTexture(mirrored(*parlour_), room::Filter::Linear);
  halo_ = room::makeTexture(room::generate(64, 64, 3,
                                           [](double u, double v, float* out) {
                                             const double r = std::min(std::hypot(2 * u - 1, 2 * v - 1), 1.0);
                                             const double glow =
                                                 (1 - r) * (1 - r) * (0.25 + 0.75 * std::exp(-9 * r * r));
                                             for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(glow);
                                           }),
                            room::Filter::Linear, GL_CLAMP_TO_EDGE);
}

void Skinning::frame(const room::View& view, std::string_view stage) {
  const double flicker = flickerAt(view.time);
  room::resetPasses(2);
  glClearColor(0, 0, 0, 1);
  glClearStencil(0);
  glStencilMask(~0U);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  lookFrom(view);
  skin_->pose(boneMatrices(view.time), glm::translate(glm::dmat4(1.0), kWrist));
  const bool whole = stage == "final", alone = stage == "bones" || stage == "diffuse" || stage == "specular";
  if (!alone) drawParlour(flicker);
  if (whole || stage == "shadows") drawShadows();
  if (whole || alone) drawHand(stage, flicker);
  if (whole) {
    drawBall(stage);
    drawHalos(flicker);
  }
  room::resetPasses(2);
}

void Skinning::lookFrom(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(7.0 + 9.0 * std::sin(turn / 37.0));
  const glm::dvec3 target(0.035, 1.045, 0);
  const glm::dvec3 eye = target + glm::dvec3(1.40 * std::sin(angle), 0.20 + 0.03 * std::sin(turn / 23.0),
                                             1.40 * std::cos(angle));
  camera_ = glm::lookAt(room::orbited(view, eye, target), target, glm::dvec3(0, 1, 0));
  glViewport(0, 0, view.width, view.height);
  glMatrixMode(GL_PROJECTION);
  room::loadMatrix(
      glm::perspective(glm::radians(41.0), static_cast<double>(view.width) / view.height, 0.1, 12.0));
  glMatrixMode(GL_MODELVIEW);
  room::loadMatrix(camera_);
}

// Color = base * light in the vertices, then * 2 * flicker.
void Skinning::drawParlour(double flicker) const {
  glEnableClientState(GL_COLOR_ARRAY);
  // Unit 1 samples nothing that is used: a unit works only with a texture.
  const glm::vec4 strength(glm::vec3(static_cast<float>(glm::min(flicker, 1.0))), 1);
  for (const Part& part : parlour_->parts()) {
    useTexture(0, *part.base);
    modulate();
    useTexCoords(0, *part.mesh);
    useTexture(1, *part.base);
    combine(GL_MODULATE, GL_PREVIOUS, GL_CONSTANT, part.surface == Surface::Glowing ? 1 : 2);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(strength));
    const GLuint mark = part.surface == Surface::Table  ? kTableBit
                        : part.surface == Surface::Wall ? kWallBit
                                                        : 0;
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, static_cast<GLint>(mark), ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    part.mesh->bindPositions();
    part.mesh->bindColors();
    part.mesh->draw();
  }
  room::resetPasses(2);
}

// The hand's, on the table and on the wall.
void Skinning::drawShadows() const {
  glEnable(GL_STENCIL_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  // Each takes its share of the lamp's light.
  setColor(glm::dvec3(0.80, 0.815, 0.84));
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2, -4);
  GLuint mark = 1;
  skin_->begin(camera_);
  for (const glm::dvec3& flame : kFlames) {
    drawShadow({0, 1, 0, -kTableTop - 0.001}, kTableBit, kLamp + flame, mark);
    drawShadow({0, 0, 1, -kRoomMin.z - 0.002}, kWallBit, kLamp + flame, mark);
    mark <<= 1;
  }
  skin_->end();
  room::loadMatrix(camera_);
  glStencilMask(~0U);
  glDisable(GL_POLYGON_OFFSET_FILL);
  room::resetPasses(2);
}

// Where `receiver` is marked and `mark` not yet; marks it.
void Skinning::drawShadow(glm::dvec4 plane, GLuint receiver, const glm::dvec3& light, GLuint mark) const {
  glStencilFunc(GL_EQUAL, static_cast<GLint>(receiver), receiver | mark);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
  glStencilMask(mark);
  skin_->look(camera_ * room::planarShadow(plane, light));
  skin_->draw();
}

// Positions are in the room; the camera's matrix is current.
void Skinning::placeLights(double flicker) const {
  struct Source {
    glm::vec4 position;
    glm::vec3 color;
    float quadratic;
  };
  const std::vector<glm::dvec3>& candles = parlour_->candles();
  const auto steady = static_cast<float>(flicker);
  const std::array<Source, 4> sources = {{
      {{kLamp, 1}, glm::vec3(1.24F, 0.99F, 0.73F) * steady, 0.38F},
      {{candles[0], 1}, glm::vec3(0.62F, 0.38F, 0.17F) * steady, 2.2F},
      {{candles[1], 1}, glm::vec3(0.62F, 0.38F, 0.17F) * steady, 2.2F},
      {{kWindowCorner + glm::dvec3(kWindowSize * 0.5, 0), 1}, glm::vec3(0.30F, 0.42F, 0.72F), 0.0F},
  }};
  room::loadMatrix(camera_);
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

// Unit 0 RGB = Base.RGB * Diffuse.RGB, alpha = Specular.A * Base.A; unit 1 RGB = Previous.RGB + Previous.A.
void Skinning::useGlazing(std::string_view stage, const room::Texture& base) const {
  // What the cube map is looked up by comes in eye coordinates: back to the room's.
  loadTextureMatrix(1, glm::dmat4(glm::transpose(glm::dmat3(camera_))));
  glActiveTexture(GL_TEXTURE1);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  highlights_.bind();
  const auto texGen = reinterpret_cast<PFNGLTEXGENIOESPROC>(eglGetProcAddress("glTexGeniOES"));
  texGen(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
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

  useTexture(0, base);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_MODULATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_MODULATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_TEXTURE1);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_ALPHA, GL_TEXTURE);
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);
}

void Skinning::endGlazing() const {
  glActiveTexture(GL_TEXTURE0);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
  glActiveTexture(GL_TEXTURE1);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_SRC_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_SRC_COLOR);
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  glDisable(GL_TEXTURE_GEN_STR_OES);
  room::resetPasses(2);
}

void Skinning::drawHand(std::string_view stage, double flicker) const {
  placeLights(flicker);
  if (stage == "bones") {
    glEnable(GL_COLOR_MATERIAL);
  } else {
    useGlazing(stage, handBase_);
  }
  glEnable(GL_LIGHTING);
  skin_->begin(camera_);
  if (stage == "bones") skin_->showBones();
  skin_->draw();
  skin_->end();
  glDisable(GL_COLOR_MATERIAL);
  glDisable(GL_LIGHTING);
  room::loadMatrix(camera_);
  endGlazing();
}

void Skinning::drawBall(std::string_view stage) const {
  useGlazing(stage, parlour_->ballBase());
  const room::Mesh& ball = parlour_->ball();
  glEnableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  useTexCoords(0, ball);
  ball.bindPositions();
  ball.bindNormals();
  ball.bindColors();
  ball.draw();
  endGlazing();
}

// The air around the flames.
void Skinning::drawHalos(double flicker) const {
  constexpr std::array<GLfloat, 8> kCorners = {0, 0, 1, 0, 0, 1, 1, 1};
  const glm::dmat3 toRoom = glm::transpose(glm::dmat3(camera_));
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  useTexture(0, halo_);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, kCorners.data());
  for (const glm::dvec3& candle : parlour_->candles()) {
    const double size = 0.34 * flicker;
    std::array<glm::vec3, 4> quad;
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = candle +
                toRoom * glm::dvec3(size * (kCorners[2 * i] - 0.5), size * (kCorners[2 * i + 1] - 0.5), 0.03);
    setColor(glm::dvec3(0.62, 0.36, 0.13) * flicker);
    glVertexPointer(3, GL_FLOAT, 0, quad.data());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  room::resetPasses(2);
}

}  // namespace

std::unique_ptr<room::Demo> makeSkinning() {
  return std::make_unique<Skinning>();
}

}  // namespace skinning
