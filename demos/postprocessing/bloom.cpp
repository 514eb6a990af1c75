#include "bloom.h"

#include <glm/glm.hpp>

#include "postprocessing.h"
#include "room/passes.h"

namespace postprocessing {
namespace {

constexpr std::array<glm::dvec2, 4> kTaps = {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

void drawQuad(const room::RenderTarget& picture, glm::dvec2 offset) {
  static constexpr std::array<GLbyte, 8> kCorners = {-1, -1, 1, -1, -1, 1, 1, 1};
  std::array<glm::vec2, 4> coordinates;
  for (std::size_t i = 0; i < 4; ++i) {
    coordinates[i] = (glm::dvec2(kCorners[2 * i], kCorners[2 * i + 1]) + 1.0) * 0.5 + offset;
  }
  picture.bindTexture();
  glVertexPointer(2, GL_BYTE, 0, kCorners.data());
  glTexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

// color += weight * the mean of four samples that lie `texels` of the source off the diagonals.
void addBlurred(const room::RenderTarget& source, double texels, double weight) {
  const auto share = static_cast<GLfloat>(weight / kTaps.size());
  glColor4f(share, share, share, 1);
  for (const glm::dvec2& tap : kTaps) drawQuad(source, tap * (texels / source.size()));
}

// Quads in normalized device coordinates, one texture times the current color, everything else off.
void beginQuads() {
  room::resetPasses(kUnits);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_TEXTURE_2D);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
}

}  // namespace

Bloom::Bloom(const room::FramebufferFunctions& gl)
    : mask_(gl, kMaskSize, room::RenderTarget::Depth::Bits16),
      reductions_{{{gl, kReductions[0].size},
                   {gl, kReductions[1].size},
                   {gl, kReductions[2].size},
                   {gl, kReductions[3].size}}},
      glare_(gl, kMaskSize) {}

void Bloom::render(const std::function<void()>& drawMask) {
  glClearColor(0, 0, 0, 1);
  mask_.bind();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  drawMask();

  beginQuads();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  // Linear filtering between four texels and four taps a texel apart: a 4x4 box, at every size.
  const room::RenderTarget* source = &mask_;
  for (const room::RenderTarget& reduction : reductions_) {
    reduction.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    addBlurred(*source, 1.0, 1.0);
    source = &reduction;
  }
  // Half a texel apart on the way up: bilinear magnification alone would show its texels as diamonds.
  glare_.bind();
  glClear(GL_COLOR_BUFFER_BIT);
  for (std::size_t i = 0; i < reductions_.size(); ++i) {
    addBlurred(reductions_[i], 0.5, kReductions[i].weight);
  }
  glare_.unbind();
}

void Bloom::addGlare(const glm::dvec3& color) const {
  beginQuads();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  room::setColor(color);
  drawQuad(glare_, glm::dvec2(0));
}

void showPicture(const room::RenderTarget& picture) {
  beginQuads();
  drawQuad(picture, glm::dvec2(0));
}

}  // namespace postprocessing
