#include "specular.h"

#include <EGL/egl.h>

#include <array>

#include "lighting.h"
#include "room/context.h"
#include "room/noise.h"
#include "room/passes.h"
#include "room/transform.h"

namespace lighting {
namespace {

constexpr int kHighlightSize = 128;
constexpr double kHighlight = 0.75;  // keeps the brightest light's color below 1

// A highlight about the +Z axis, drawn out along y as on brushed sheet metal: a sharp core in a broad sheen.
std::array<room::Image, 6> highlightFaces() {
  std::array<room::Image, 6> faces;
  for (int face = 0; face < 6; ++face) {
    faces[static_cast<std::size_t>(face)] =
        room::generate(kHighlightSize, kHighlightSize, 1, [face](double s, double t, float* out) {
          const glm::dvec3 d = room::cubeDirection(face, s, t);
          const double core = room::bell(d.x, 0, 0.11) * room::bell(d.y, 0, 1.10);
          const double sheen = room::bell(d.x, 0, 0.42) * room::bell(d.y, 0, 1.10);
          *out = static_cast<float>((0.70 * core + 0.45 * sheen) * room::smoothStep(-0.05, 0.35, d.z));
        });
  }
  return faces;
}

}  // namespace

Specular::Specular() {
  room::requireExtension("GL_OES_texture_cube_map", "lighting");
  texGeni_ = reinterpret_cast<PFNGLTEXGENIOESPROC>(eglGetProcAddress("glTexGeniOES"));
  highlight_ = room::makeCubeTexture(highlightFaces(), room::Filter::Linear);
}

// The texture matrix turns the light's direction to the cube map's +Z axis and the object's upright axis to
// +Y.
void Specular::draw(const LightVectors& lit, const Spotlight& light, const glm::dmat4& view) const {
  beginPass();
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ONE);
  glEnableClientState(GL_NORMAL_ARRAY);
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  highlight_.bind();
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
  room::modulate();
  for (const LitPart& one : lit.parts()) {
    const Part& part = *one.part;
    if (part.shine <= 0) continue;
    place(part, view);
    const glm::dvec3 toLight = glm::normalize(glm::dmat3(view) * (light.position - centerOf(part)));
    room::loadTextureMatrix(0, room::rotationToAxes(toLight, glm::dmat3(view) * glm::dvec3(part.model[1])));
    room::useTexture(1, part.material->gloss);
    room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 4);
    room::useTexCoords(1, *part.mesh);
    part.mesh->bindPositions();
    part.mesh->bindNormals();
    room::setColor(light.color * (kHighlight * part.shine));
    part.mesh->draw();
  }
  glActiveTexture(GL_TEXTURE0);
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  glDisable(GL_TEXTURE_GEN_STR_OES);
}

}  // namespace lighting
