#include "plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "font.h"

namespace room {
namespace {

using glm::dvec2;

constexpr glm::vec3 kPaper(0.985F, 0.98F, 0.965F);
constexpr glm::vec3 kInk(0.13F, 0.13F, 0.16F);
constexpr glm::vec3 kGrid(0.84F, 0.84F, 0.84F);

bool shown(const PlotPoint& p) {
  return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y);
}

// Blends a color in wherever a distance, in pixels, is below zero.
template <typename Distance>
void paint(Image& image, dvec2 low, dvec2 high, glm::vec3 color, const Distance& distance) {
  const OIIO::ImageSpec& spec = image.spec();
  const glm::ivec2 from = glm::max(glm::ivec2(low - 1.0), glm::ivec2(0));
  const glm::ivec2 to = glm::min(glm::ivec2(high + 2.0), glm::ivec2(spec.width, spec.height));
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) {
      const auto share = static_cast<float>(std::clamp(0.5 - distance(dvec2(x + 0.5, y + 0.5)), 0.0, 1.0));
      auto* pixel = static_cast<float*>(image.pixeladdr(x, y));
      for (int i = 0; i < 3; ++i) pixel[i] = glm::mix(pixel[i], color[i], share);
    }
  }
}

void paintLine(Image& image, dvec2 a, dvec2 b, double half, glm::vec3 color) {
  paint(image, glm::min(a, b) - half, glm::max(a, b) + half, color, [=](dvec2 p) {
    const dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + along * t) - half;
  });
}

void paintMarker(Image& image, dvec2 at, Marker marker, double size, glm::vec3 color) {
  if (marker == Marker::Disc) {
    paint(image, at - size, at + size, color, [=](dvec2 p) { return glm::distance(p, at) - size; });
  } else {
    paintLine(image, at - size, at + size, size * 0.28, color);
    paintLine(image, at + dvec2(-size, size), at + dvec2(size, -size), size * 0.28, color);
  }
}

// Powers of ten to pixels.
struct Axes {
  glm::ivec2 low;  // exponents
  glm::ivec2 high;
  dvec2 origin;  // pixels of (low.x, low.y)
  dvec2 size;    // pixels; y grows upwards

  dvec2 at(dvec2 exponents) const {
    const dvec2 part = (exponents - dvec2(low)) / dvec2(high - low);
    return {origin.x + part.x * size.x, origin.y - part.y * size.y};
  }
};

Axes axesFor(const Plot& plot, int width, int height) {
  dvec2 low(1e300);
  dvec2 high(-1e300);
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& p : series.points) {
      if (!shown(p)) continue;
      low = glm::min(low, dvec2(std::log10(p.x), std::log10(p.y)));
      high = glm::max(high, dvec2(std::log10(p.x), std::log10(p.y)));
    }
  }
  if (low.x > high.x) throw std::invalid_argument("a plot without points");
  Axes axes{glm::ivec2(glm::floor(low)), glm::ivec2(glm::ceil(high)), {}, {}};
  axes.high = glm::max(axes.high, axes.low + 1);
  axes.origin = {0.10 * width, 0.90 * height};
  axes.size = {0.86 * width, 0.78 * height};
  return axes;
}

void drawAxes(Image& image, const Plot& plot, const Axes& axes, double letter) {
  const auto textWidth = [&](const std::string& text) {
    return static_cast<double>(text.size()) * kGlyphAdvance / kGlyphHeight * letter;
  };
  for (int x = axes.low.x; x <= axes.high.x; ++x) {
    const dvec2 foot = axes.at({x, axes.low.y});
    paintLine(image, foot, axes.at({x, axes.high.y}), 0.5, kGrid);
    const std::string text = fmt::format("1e{}", x);
    drawText(image, foot + dvec2(-textWidth(text) / 2, 1.8 * letter), letter, text, kInk);
  }
  for (int y = axes.low.y; y <= axes.high.y; ++y) {
    const dvec2 foot = axes.at({axes.low.x, y});
    paintLine(image, foot, axes.at({axes.high.x, y}), 0.5, kGrid);
    const std::string text = fmt::format("1e{}", y);
    drawText(image, foot + dvec2(-textWidth(text) - 0.5 * letter, 0.5 * letter), letter, text, kInk);
  }
  paintLine(image, axes.at(axes.low), axes.at({axes.high.x, axes.low.y}), 1, kInk);
  paintLine(image, axes.at(axes.low), axes.at({axes.low.x, axes.high.y}), 1, kInk);
  const dvec2 top = axes.at({axes.low.x, axes.high.y});
  drawText(image, top - dvec2(0, 2.6 * letter), letter * 1.25, plot.title, kInk);
  drawText(image, top - dvec2(0, 0.7 * letter), letter, plot.yLabel, kInk);
  const dvec2 right = axes.at({axes.high.x, axes.low.y});
  drawText(image, right + dvec2(-textWidth(plot.xLabel), 3.6 * letter), letter, plot.xLabel, kInk);
}

}  // namespace

Picture drawPlot(const Plot& plot, int width, int height) {
  const Axes axes = axesFor(plot, width, height);
  const double letter = height / 52.0;
  Image image = generate(width, height, 3, [](double, double, float* out) {
    for (int i = 0; i < 3; ++i) out[i] = kPaper[i];
  });
  drawAxes(image, plot, axes, letter);
  for (const PlotSeries& series : plot.series) {
    const PlotPoint* last = nullptr;
    for (const PlotPoint& p : series.points) {
      if (!shown(p)) continue;
      const dvec2 at = axes.at({std::log10(p.x), std::log10(p.y)});
      if (last != nullptr) {
        paintLine(image, axes.at({std::log10(last->x), std::log10(last->y)}), at, 0.7,
                  glm::mix(series.color, kPaper, 0.35F));
      }
      last = &p;
    }
    for (const PlotPoint& p : series.points) {
      if (shown(p))
        paintMarker(image, axes.at({std::log10(p.x), std::log10(p.y)}), p.marker, letter * 0.36,
                    series.color);
    }
  }
  dvec2 place = axes.at(axes.low) + dvec2(0, 3.6 * letter);
  for (const PlotLegend& entry : plot.legend) {
    paintMarker(image, place + dvec2(0.5 * letter, -0.5 * letter), Marker::Disc, letter * 0.4, entry.color);
    drawText(image, place + dvec2(1.5 * letter, 0), letter, entry.text, kInk);
    place.x += (3 + static_cast<double>(entry.text.size()) * kGlyphAdvance / kGlyphHeight) * letter;
  }
  Picture picture{width, height, {}};
  const auto* pixels = static_cast<const float*>(image.localpixels());
  picture.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  std::transform(pixels, pixels + picture.rgb.size(), picture.rgb.begin(),
                 [](float x) { return static_cast<std::uint8_t>(x * 255 + 0.5F); });
  return picture;
}

}  // namespace room
