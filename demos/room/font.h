// Letters drawn from strokes: capitals, digits and signs, for overlays and plots.
#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include "image.h"

namespace room {

// A glyph's strokes lie in [0,4] x [0,6], y up; the next glyph starts kGlyphAdvance further.
inline constexpr double kGlyphAdvance = 5.6;
inline constexpr double kGlyphHeight = 6;

// From a point to the nearest stroke of a character, 1e9 for one without any. Small letters look as capitals
// do; what the font does not have is a box.
double glyphDistance(char character, glm::dvec2 point);

// All characters from ' ' to '_', sixteen a row, the first row at v = 0; each glyph upright in its cell.
inline constexpr int kFontColumns = 16;
inline constexpr int kFontRows = 4;
inline constexpr glm::dvec2 kFontCell{5.6, 8.0};  // what a cell covers; the glyph starts kFontMargin inside
inline constexpr glm::dvec2 kFontMargin{0.8, 1.0};
Image fontImage();  // 1 channel

// Into an image whose row 0 is above: left and bottom of the first letter, and the letters' height, in
// pixels.
void drawText(Image& image, glm::dvec2 at, double height, std::string_view text, glm::vec3 color);

}  // namespace room
