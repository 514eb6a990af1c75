#include "overlay.h"

#include <algorithm>
#include <cctype>

#include "font.h"
#include "passes.h"

namespace room {

Overlay::Overlay() : font_(makeTexture(fontImage(), Filter::Mipmapped, GL_CLAMP_TO_EDGE, GL_ALPHA)) {}

void Overlay::addQuad(glm::dvec2 low, glm::dvec2 high, glm::dvec2 uvLow, glm::dvec2 uvHigh) {
  const auto corner = [&](double x, double y) {
    positions_.emplace_back(glm::mix(low, high, glm::dvec2(x, y)));
    texCoords_.emplace_back(glm::mix(uvLow, uvHigh, glm::dvec2(x, y)));
  };
  corner(0, 0);
  corner(1, 0);
  corner(1, 1);
  corner(0, 0);
  corner(1, 1);
  corner(0, 1);
}

// unit: pixels of a glyph's unit.
void Overlay::addLine(glm::dvec2 at, double unit, std::string_view text) {
  const glm::dvec2 cell(1.0 / kFontColumns, 1.0 / kFontRows);
  for (char character : text) {
    const int index = std::clamp(std::toupper(static_cast<unsigned char>(character)) - ' ', 0, 63);
    const glm::dvec2 from = glm::dvec2(index % kFontColumns, index / kFontColumns) * cell;
    const glm::dvec2 low = at - kFontMargin * unit;
    addQuad(low, low + kFontCell * unit, from, from + cell);
    at.x += kGlyphAdvance * unit;
  }
}

// Pixels as coordinates, blending, and the arrays of what has been added.
void Overlay::begin(const View& view) const {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrthof(0, static_cast<GLfloat>(view.width), 0, static_cast<GLfloat>(view.height), -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glActiveTexture(GL_TEXTURE0);
  glDisable(GL_TEXTURE_2D);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions_.data());
  glTexCoordPointer(2, GL_FLOAT, 0, texCoords_.data());
}

// From a vertex on.
void Overlay::drawLetters(std::size_t first) const {
  useTexture(0, font_);
  modulate();
  setColor(glm::dvec3(1.0, 0.93, 0.75));
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(positions_.size() - first));
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glDisable(GL_BLEND);
}

void Overlay::draw(const View& view, const std::vector<std::string>& lines, double darkness) {
  const double unit = view.height / 56.0 / kGlyphHeight;
  const double lineHeight = 9.5 * unit;
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, line.size());
  const glm::dvec2 margin(4 * unit, 4 * unit);
  positions_.clear();
  texCoords_.clear();
  // A dark ground, where the font's texture is not asked for.
  const glm::dvec2 ground(static_cast<double>(widest) * kGlyphAdvance * unit,
                          static_cast<double>(lines.size()) * lineHeight);
  addQuad({margin.x, view.height - 3 * margin.y - ground.y},
          {3 * margin.x + ground.x, view.height - margin.y}, {0, 0}, {0, 0});
  double y = view.height - 2 * margin.y - lineHeight + 1.5 * unit;
  for (const std::string& line : lines) {
    addLine({2 * margin.x, y}, unit, line);
    y -= lineHeight;
  }
  begin(view);
  setColor(glm::dvec3(0), darkness);
  glDrawArrays(GL_TRIANGLES, 0, 6);
  drawLetters(6);
}

void Overlay::label(const View& view, glm::dvec2 at, double height, std::string_view text) {
  positions_.clear();
  texCoords_.clear();
  addLine(at, height / kGlyphHeight, text);
  begin(view);
  drawLetters(0);
}

}  // namespace room
