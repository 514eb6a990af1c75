#include "font.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace room {
namespace {

using glm::dvec2;

// From ' ' to '_': strokes apart by spaces, each a row of points of two digits, x and y.
constexpr std::array<std::string_view, 64> kStrokes = {
    "",                                    //
    "2622 2120",                           // !
    "1614 3634",                           // "
    "1610 3630 0444 0242",                 // #
    "453616050413334241301001 2620",       // $
    "0046 0506151405 3041",                // %
    "40051626350201103042",                // &
    "2624",                                // '
    "36242230",                            // (
    "16242210",                            // )
    "2521 0442 0244",                      // *
    "2521 0343",                           // +
    "2110",                                // ,
    "0343",                                // -
    "2021",                                // .
    "0046",                                // /
    "100105163645413010 1134",             // 0
    "052620 1030",                         // 1
    "051636454403004000",                  // 2
    "0516364544331333424130100110",        // 3
    "30360242",                            // 4
    "46060313334241301001",                // 5
    "36160501103041423303",                // 6
    "06464510",                            // 7
    "1333444536160504130201103041423313",  // 8
    "10304145361605041343",                // 9
    "2221 2524",                           // :
    "2524 2110",                           // ;
    "450341",                              // <
    "0444 0242",                           // =
    "054301",                              // >
    "05163645342322 2021",                 // ?
    "4130100105163645423222243444",        // @
    "0004264440 0242",                     // A
    "00063645443303 3342413000",           // B
    "4536160501103041",                    // C
    "000636454130 3000",                   // D
    "46060040 0333",                       // E
    "460600 0333",                         // F
    "45361605011030414323",                // G
    "0006 4046 0343",                      // H
    "1636 2620 1030",                      // I
    "4641301001",                          // J
    "0006 460340",                         // K
    "060040",                              // L
    "0006234640",                          // M
    "00064046",                            // N
    "100105163645413010",                  // O
    "00063645443303",                      // P
    "1001051636454130102240",              // Q
    "00063645443303 2340",                 // R
    "453616050413334241301001",            // S
    "0646 2620",                           // T
    "060110304146",                        // U
    "062046",                              // V
    "0610233046",                          // W
    "0046 0640",                           // X
    "062346 2320",                         // Y
    "06460040",                            // Z
    "36161030",                            // [
    "0640",                                // backslash
    "16363010",                            // ]
    "042644",                              // ^
    "0040"                                 // _
};

struct Segment {
  dvec2 from;
  dvec2 to;
};

std::vector<Segment> segmentsOf(std::string_view strokes) {
  std::vector<Segment> segments;
  while (!strokes.empty()) {
    const std::size_t length = std::min(strokes.find(' '), strokes.size());
    const auto point = [&](std::size_t i) { return dvec2(strokes[i] - '0', strokes[i + 1] - '0'); };
    for (std::size_t i = 2; i + 1 < length; i += 2) segments.push_back({point(i - 2), point(i)});
    strokes.remove_prefix(std::min(length + 1, strokes.size()));
  }
  return segments;
}

const std::vector<Segment>& glyph(char character) {
  static const std::vector<std::vector<Segment>> glyphs = [] {
    std::vector<std::vector<Segment>> all;
    for (std::string_view strokes : kStrokes) all.push_back(segmentsOf(strokes));
    all.push_back(segmentsOf("0006464000"));
    return all;
  }();
  const int index = std::toupper(static_cast<unsigned char>(character)) - ' ';
  const bool known = index >= 0 && index < static_cast<int>(kStrokes.size());
  return glyphs[known ? static_cast<std::size_t>(index) : kStrokes.size()];
}

double coverage(double distance, double pixel) {
  constexpr double kHalfWidth = 0.42;
  return std::clamp((kHalfWidth - distance) / pixel + 0.5, 0.0, 1.0);
}

}  // namespace

double glyphDistance(char character, dvec2 point) {
  double nearest = 1e9;
  for (const Segment& s : glyph(character)) {
    const dvec2 along = s.to - s.from;
    const double length = glm::dot(along, along);
    const double t = length > 0 ? std::clamp(glm::dot(point - s.from, along) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, glm::distance(point, s.from + along * t));
  }
  return nearest;
}

Image fontImage() {
  constexpr int kCellWidth = 32;
  constexpr int kCellHeight = 64;
  return generate(kCellWidth * kFontColumns, kCellHeight * kFontRows, 1, [](double u, double v, float* out) {
    const dvec2 at(u * kFontColumns, v * kFontRows);
    const glm::ivec2 cell(at);
    const dvec2 point = (at - dvec2(cell)) * kFontCell - kFontMargin;
    const char character = static_cast<char>(' ' + cell.y * kFontColumns + cell.x);
    *out = static_cast<float>(coverage(glyphDistance(character, point), kFontCell.x / kCellWidth));
  });
}

void drawText(Image& image, dvec2 at, double height, std::string_view text, glm::vec3 color) {
  const double unit = height / kGlyphHeight;
  const OIIO::ImageSpec& spec = image.spec();
  for (char character : text) {
    const glm::ivec2 low = glm::max(glm::ivec2(at - dvec2(unit, height + unit)), glm::ivec2(0));
    const glm::ivec2 high =
        glm::min(glm::ivec2(at + dvec2(5 * unit, unit)) + 1, glm::ivec2(spec.width, spec.height));
    for (int y = low.y; y < high.y; ++y) {
      for (int x = low.x; x < high.x; ++x) {
        const dvec2 point = dvec2(x + 0.5 - at.x, at.y - y - 0.5) / unit;
        const auto share = static_cast<float>(coverage(glyphDistance(character, point), 1 / unit));
        auto* pixel = static_cast<float*>(image.pixeladdr(x, y));
        for (int i = 0; i < 3; ++i) pixel[i] = glm::mix(pixel[i], color[i], share);
      }
    }
    at.x += kGlyphAdvance * unit;
  }
}

}  // namespace room
