#include "draw_atrium.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "room/passes.h"
#include "room/transform.h"
#include "water/water.h"

namespace water {
namespace {

// x and z from the middle of the pool, and in between a turn, radians.
constexpr std::array<glm::dvec3, 3> kLilies = {{{-0.75, 0, -0.85}, {0.95, 1.9, 0.25}, {-1.15, 4.1, 0.75}}};

// Color = base * scale * light in the vertices.
void drawLit(const room::Mesh& mesh, const room::Texture& base, float scale) {
  room::useTexture(0, base);
  room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, scale);
  room::useTexCoords(0, mesh);
  mesh.bindPositions();
  mesh.bindColors();
  mesh.draw();
}

}  // namespace

void drawLightmapped(const Surface& surface) {
  room::useTexture(0, *surface.base);
  room::modulate();
  room::useTexCoords(0, *surface.mesh);
  room::useTexture(1, *surface.lightmap);
  room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
  room::useTexCoords(1, *surface.mesh, true);
  room::loadTextureMatrix(1, surface.toLightmap);
  surface.mesh->bindPositions();
  surface.mesh->draw();
}

void drawAboveFloor(const Atrium& atrium, const room::Camera& camera) {
  room::resetPasses(kUnits);
  room::useCamera(camera);
  for (const Surface& wall : atrium.walls()) drawLightmapped(wall);
  room::resetPasses(kUnits);
  glEnableClientState(GL_COLOR_ARRAY);
  for (const Furniture& piece : atrium.furniture()) {
    if (piece.twoSided) glDisable(GL_CULL_FACE);
    drawLit(*piece.mesh, *piece.base, piece.scale);
    glEnable(GL_CULL_FACE);
  }
}

void drawPool(const Atrium& atrium) {
  room::resetPasses(kUnits);
  room::useTexture(0, atrium.poolTexture());
  room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, kLightScale);
  room::useTexCoords(0, atrium.pool());
  atrium.pool().bindPositions();
  atrium.pool().draw();
}

void drawLilies(const Atrium& atrium, const Sheet& sheet, const room::Camera& camera) {
  room::resetPasses(kUnits);
  glDisable(GL_CULL_FACE);
  glEnableClientState(GL_COLOR_ARRAY);
  for (const glm::dvec3& lily : kLilies) {
    const Sheet::Point point = sheet.at({lily.x, lily.z});
    glm::dmat4 model = glm::translate(
        glm::dmat4(1.0),
        glm::dvec3(kPoolCenter.x + lily.x, kWaterLevel + point.height + 0.004, kPoolCenter.y + lily.z));
    model = glm::rotate(model, std::atan2(point.normal.z, point.normal.y), glm::dvec3(1, 0, 0));
    model = glm::rotate(model, -std::atan2(point.normal.x, point.normal.y), glm::dvec3(0, 0, 1));
    room::loadMatrix(camera.view * glm::rotate(model, lily.y, glm::dvec3(0, 1, 0)));
    drawLit(atrium.lilyLeaves(), atrium.leaf(), kLightScale);
    drawLit(atrium.lilyPetals(), atrium.petal(), kLightScale);
  }
  room::loadMatrix(camera.view);
}

void drawShaft(const Atrium& atrium) {
  room::resetPasses(kUnits);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glEnableClientState(GL_COLOR_ARRAY);
  room::useTexture(0, atrium.shaftTexture());
  room::modulate();
  room::useTexCoords(0, atrium.shaft());
  atrium.shaft().bindPositions();
  atrium.shaft().bindColors();
  atrium.shaft().draw();
  room::resetPasses(kUnits);
}

}  // namespace water
