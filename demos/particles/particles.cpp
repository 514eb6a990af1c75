#include "particles.h"

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <stdexcept>

#include "fire.h"
#include "room/context.h"
#include "room/passes.h"
#include "room/transform.h"
#include "set/cellar.h"

namespace particles {
namespace {

using room::combine;
using room::loadTextureMatrix;
using room::modulate;
using room::setColor;
using room::useTexCoords;
using room::useTexture;

constexpr std::array<std::string_view, 3> kStages = {"room", "fire", "final"};
constexpr int kUnits = 2;
constexpr double kFieldOfView = 48;  // degrees, from below to above
constexpr double kVgaHeight = 480;
constexpr glm::dvec3 kFireBase = kBrazier + glm::dvec3(0, kCoalHeight + 0.01, 0);

// size' = size / sqrt(a + b d + c d^2), section 3.3.
struct Attenuation {
  double a;
  double b;
  double c;
  double at(double distance) const { return 1 / std::sqrt(a + b * distance + c * distance * distance); }
};

Attenuation attenuationFor(const room::View& view) {
  const double scale = view.height / kVgaHeight;
  return {scale * scale, 0, scale * 0.15};
}

// The attenuation makes points smaller where the screen is larger. The sizes in the array make up for that,
// so that the fire, where it stands, covers the same part of any screen.
double sizeScaleFor(const room::View& view, double distance) {
  const Attenuation vga{1, 0, 0.15};
  return view.height / kVgaHeight * vga.at(distance) / attenuationFor(view).at(distance);
}

// The fire's light with the color it has at that strength: a dim fire is redder.
glm::dvec3 lightOf(double strength) {
  return {strength, std::pow(strength, 1.12), std::pow(strength, 1.25)};
}

// The particles as two triangles each, made by the program.
struct Quads {
  static constexpr std::size_t kBatch = 16384;  // as many as 16-bit indices reach
  std::vector<glm::vec3> positions;             // eye coordinates
  std::vector<glm::vec4> colors;
  std::vector<glm::vec2> texCoords;
  std::vector<GLushort> indices;
};

// Whether sizes from the array are attenuated, as OES_point_size_array wants it; some implementations
// attenuate the current size instead. Draws a point of 16 pixels, less half, into the corner of the surface.
bool attenuatesArray() {
  constexpr GLsizei kSide = 16;
  constexpr std::array<GLfloat, 2> kMiddle = {0, 0};
  constexpr GLfloat kSize = kSide;
  constexpr std::array<GLfloat, 3> kHalf = {4, 0, 0};
  room::resetPasses(kUnits);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glViewport(0, 0, kSide, kSide);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, kHalf.data());
  glEnableClientState(GL_POINT_SIZE_ARRAY_OES);
  glPointSizePointerOES(GL_FLOAT, 0, &kSize);
  glVertexPointer(2, GL_FLOAT, 0, kMiddle.data());
  setColor(glm::dvec3(1));
  glDrawArrays(GL_POINTS, 0, 1);
  glDisableClientState(GL_POINT_SIZE_ARRAY_OES);
  std::array<std::array<GLubyte, 4>, kSide> row{};
  glReadPixels(0, kSide / 2, kSide, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
  return row[6][0] > 127 && row[2][0] < 128;
}

class Particles final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void configure(const room::Settings& settings) override { settings_ = settings; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void lookFrom(const room::View& view);
  void drawWalls(const Flicker& flicker);
  void drawFurniture(const Flicker& flicker);
  void beginAdding();
  void drawHalo(const Flicker& flicker);
  void drawPoints(const Attenuation& attenuation);
  void drawQuads(const room::View& view, const Attenuation& attenuation);
  void makeQuads(const room::View& view, const Attenuation& attenuation, std::size_t first,
                 std::size_t count);

  room::Settings settings_;
  std::optional<Cellar> cellar_;
  std::optional<Fire> fire_;
  room::Texture flame_;
  std::array<GLfloat, 2> sizeRange_{1, 1};
  bool attenuatesArray_ = true;
  glm::dmat4 camera_{1.0};
  ParticleArrays particles_;
  Quads quads_;
};

void Particles::setup() {
  if (!settings_.quads) {
    if (!room::hasExtension("GL_OES_point_sprite") || !room::hasExtension("GL_OES_point_size_array")) {
      throw std::runtime_error(
          "the fire needs GL_OES_point_sprite and GL_OES_point_size_array, which this implementation does "
          "not "
          "have; --quads does without");
    }
  }
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, sizeRange_.data());
  if (!settings_.quads) attenuatesArray_ = attenuatesArray();
  cellar_.emplace();
  fire_.emplace(kFireBase, settings_.particles);
  // Small and soft, so that even sparks of few pixels need no mip levels, which implementations choose
  // differently for points.
  flame_ = room::makeTexture(flameImage(), room::Filter::Linear, GL_CLAMP_TO_EDGE);
}

void Particles::frame(const room::View& view, std::string_view stage) {
  lookFrom(view);
  room::resetPasses(kUnits);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const Flicker flicker = fire_->flicker(view.time);
  if (stage != "fire") {
    drawWalls(flicker);
    drawFurniture(flicker);
  }
  if (stage != "room") {
    const double distance = glm::length(glm::dvec3(camera_ * glm::dvec4(kFireBase, 1.0)));
    fire_->evaluate(view.time, sizeScaleFor(view, distance), particles_);
    beginAdding();
    if (stage != "fire") drawHalo(flicker);
    if (settings_.quads) {
      drawQuads(view, attenuationFor(view));
    } else {
      drawPoints(attenuationFor(view));
    }
  }
  room::resetPasses(kUnits);
  glDepthMask(GL_TRUE);
}

void Particles::lookFrom(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(11.0 * std::sin(turn / 31.0 + 0.5));
  const glm::dvec3 target = kBrazier + glm::dvec3(0, 1.12, 0);
  const glm::dvec3 eye =
      target + glm::dvec3(4.0 * std::sin(angle), 0.40 + 0.10 * std::sin(turn / 19.0), 4.0 * std::cos(angle));
  camera_ = glm::lookAt(room::orbited(view, eye, target), target, glm::dvec3(0, 1, 0));
  glViewport(0, 0, view.width, view.height);
  glMatrixMode(GL_PROJECTION);
  room::loadMatrix(
      glm::perspective(glm::radians(kFieldOfView), static_cast<double>(view.width) / view.height, 0.1, 20.0));
  glMatrixMode(GL_MODELVIEW);
  room::loadMatrix(camera_);
}

// Color = base * flicker, then * 2 * lightmap.
void Particles::drawWalls(const Flicker& flicker) {
  room::resetPasses(kUnits);
  for (const Wall& wall : cellar_->walls()) {
    useTexture(0, *wall.base);
    modulate();
    useTexCoords(0, *wall.mesh);
    useTexture(1, wall.lightmap);
    combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 2);
    useTexCoords(1, *wall.mesh, true);
    loadTextureMatrix(1, wall.toLightmap);
    // Flames that lean to a wall light it more.
    const double leaning = 1 - 0.10 * glm::dot(flicker.lean, wall.normal);
    setColor(lightOf(std::min(flicker.strength * leaning, 1.0)));
    wall.mesh->bindPositions();
    wall.mesh->draw();
  }
}

// Color = base * light in the vertices, then * 2 * flicker.
void Particles::drawFurniture(const Flicker& flicker) {
  room::resetPasses(kUnits);
  glEnableClientState(GL_COLOR_ARRAY);
  const glm::vec4 strength(lightOf(flicker.strength), 1.0);
  for (const Furniture& piece : cellar_->furniture()) {
    useTexture(0, *piece.base);
    modulate();
    useTexCoords(0, *piece.mesh);
    useTexture(1, *piece.base);
    combine(GL_MODULATE, GL_PREVIOUS, GL_CONSTANT, piece.glows ? 4 : 2);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(strength));
    piece.mesh->bindPositions();
    piece.mesh->bindColors();
    piece.mesh->draw();
  }
}

// Everything that is drawn in the flame's texture: premultiplied colors over what is there, hidden by the
// room but not by each other.
void Particles::beginAdding() {
  room::resetPasses(kUnits);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  useTexture(0, flame_);
}

// The air around the fire.
void Particles::drawHalo(const Flicker& flicker) {
  constexpr std::array<GLfloat, 8> kCorners = {0, 0, 1, 0, 0, 1, 1, 1};
  const double size = 3.6 * (0.9 + 0.1 * flicker.strength);
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(camera_));
  std::array<glm::vec3, 4> quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 offset = size * glm::dvec2(kCorners[2 * i] - 0.5, kCorners[2 * i + 1] - 0.5);
    quad[i] = kFireBase + glm::dvec3(0, 0.35, 0) + toWorld * glm::dvec3(offset, 0);
  }
  glDisable(GL_DEPTH_TEST);
  setColor(glm::dvec3(0.30, 0.125, 0.035) * lightOf(flicker.strength), 0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, kCorners.data());
  glVertexPointer(3, GL_FLOAT, 0, quad.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glEnable(GL_DEPTH_TEST);
}

void Particles::drawPoints(const Attenuation& attenuation) {
  glm::vec3 coefficients(attenuation.a, attenuation.b, attenuation.c);
  if (!attenuatesArray_) {
    for (std::size_t i = 0; i < particles_.sizes.size(); ++i) {
      const glm::dvec3 eye(camera_ * glm::dvec4(particles_.positions[i], 1.0));
      particles_.sizes[i] = static_cast<float>(particles_.sizes[i] * attenuation.at(glm::length(eye)));
    }
    coefficients = {1, 0, 0};
  }
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, glm::value_ptr(coefficients));
  glPointParameterf(GL_POINT_SIZE_MIN, sizeRange_[0]);
  glPointParameterf(GL_POINT_SIZE_MAX, sizeRange_[1]);
  glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 0);
  glEnable(GL_POINT_SPRITE_OES);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_TRUE);
  glEnableClientState(GL_COLOR_ARRAY);
  glEnableClientState(GL_POINT_SIZE_ARRAY_OES);
  glVertexPointer(3, GL_FLOAT, 0, particles_.positions.data());
  glColorPointer(4, GL_FLOAT, 0, particles_.colors.data());
  glPointSizePointerOES(GL_FLOAT, 0, particles_.sizes.data());
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(particles_.positions.size()));
  glDisableClientState(GL_POINT_SIZE_ARRAY_OES);
  glDisableClientState(GL_COLOR_ARRAY);
  glTexEnvi(GL_POINT_SPRITE_OES, GL_COORD_REPLACE_OES, GL_FALSE);
  glDisable(GL_POINT_SPRITE_OES);
}

// What the points are, section 3.3, for particles first .. first + count.
void Particles::makeQuads(const room::View& view, const Attenuation& attenuation, std::size_t first,
                          std::size_t count) {
  constexpr std::array<glm::vec2, 4> kCorners = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  quads_.positions.clear();
  quads_.colors.clear();
  quads_.texCoords.clear();
  const double pixelAtOne = 2 * std::tan(glm::radians(kFieldOfView) / 2) / view.height;
  for (std::size_t i = first; i < first + count; ++i) {
    const glm::dvec3 eye(camera_ * glm::dvec4(particles_.positions[i], 1.0));
    const double derived = particles_.sizes[i] * attenuation.at(glm::length(eye));
    const double pixels = std::clamp<double>(derived, sizeRange_[0], sizeRange_[1]);
    const double metres = pixels * pixelAtOne * -eye.z;
    for (const glm::vec2& corner : kCorners) {
      // Row 0 of a point sprite's texture is above.
      quads_.positions.emplace_back(eye +
                                    glm::dvec3((corner.x - 0.5) * metres, (0.5 - corner.y) * metres, 0));
      quads_.colors.push_back(particles_.colors[i]);
      quads_.texCoords.push_back(corner);
    }
  }
  const std::size_t have = quads_.indices.size() / 6;
  for (std::size_t quad = have; quad < count; ++quad) {
    for (std::size_t corner : {0, 1, 2, 0, 2, 3})
      quads_.indices.push_back(static_cast<GLushort>(4 * quad + corner));
  }
}

void Particles::drawQuads(const room::View& view, const Attenuation& attenuation) {
  room::loadMatrix(glm::dmat4(1.0));
  glEnableClientState(GL_COLOR_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  for (std::size_t first = 0; first < particles_.positions.size(); first += Quads::kBatch) {
    const std::size_t count = std::min(Quads::kBatch, particles_.positions.size() - first);
    makeQuads(view, attenuation, first, count);
    glVertexPointer(3, GL_FLOAT, 0, quads_.positions.data());
    glColorPointer(4, GL_FLOAT, 0, quads_.colors.data());
    glTexCoordPointer(2, GL_FLOAT, 0, quads_.texCoords.data());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count), GL_UNSIGNED_SHORT, quads_.indices.data());
  }
  room::loadMatrix(camera_);
}

}  // namespace

std::unique_ptr<room::Demo> makeParticles() {
  return std::make_unique<Particles>();
}

}  // namespace particles
