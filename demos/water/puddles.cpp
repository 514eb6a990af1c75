#include "puddles.h"

#include <GLES/gl.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "room/passes.h"
#include "room/transform.h"

namespace water {
namespace {

constexpr int kMirrorSize = 1024;

// About the floor.
glm::dmat4 mirrored() {
  return glm::scale(glm::dmat4(1.0), glm::dvec3(1, -1, 1));
}

// How much a puddle reflects: more than in nature where one looks down on it.
float puddleShare(double cosine) {
  const double grazing = 1 - std::clamp(cosine, 0.0, 1.0);
  return static_cast<float>(0.16 + 0.80 * grazing * grazing);
}

}  // namespace

Puddles::Puddles(const room::FramebufferFunctions& gl)
    : mirror_(gl, kMirrorSize, room::RenderTarget::Depth::Bits16) {}

void Puddles::render(const room::Camera& camera, const std::function<void(const room::Camera&)>& drawRoom) {
  mirror_.bind();
  glFrontFace(GL_CW);
  drawRoom({camera.eye, camera.view * mirrored(), camera.projection});
  glFrontFace(GL_CCW);
  mirror_.unbind();
}

void Puddles::begin(const room::Camera& camera) const {
  glEnableClientState(GL_COLOR_ARRAY);
  glActiveTexture(GL_TEXTURE2);
  glEnable(GL_TEXTURE_2D);
  mirror_.bindTexture();
  room::combine(GL_INTERPOLATE, GL_TEXTURE, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_PREVIOUS);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
  room::loadTextureMatrix(2, room::biasMatrix() * camera.projection * camera.view * mirrored());
}

void Puddles::wet(const Surface& floor, const glm::dvec3& eye) {
  colors_.clear();
  for (const room::Vertex& v : floor.data.vertices) {
    colors_.emplace_back(1, 1, 1, puddleShare(glm::normalize(eye - v.position).y));
  }
  glColorPointer(4, GL_FLOAT, 0, colors_.data());
  room::useTexCoords(2, *floor.mesh, true);
}

}  // namespace water
