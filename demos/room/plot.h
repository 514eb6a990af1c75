// Plots with logarithmic axes, drawn into pictures.
#pragma once

#include <string>
#include <vector>

#include "image.h"
#include "picture.h"

namespace room {

enum class Marker { Disc, Cross };

struct PlotPoint {
  double x;  // positive
  double y;
  Marker marker = Marker::Disc;
};

// Points joined by lines.
struct PlotSeries {
  glm::vec3 color;
  std::vector<PlotPoint> points;
};

struct PlotLegend {
  glm::vec3 color;
  std::string text;
};

struct Plot {
  std::string title;
  std::string xLabel;
  std::string yLabel;
  std::vector<PlotSeries> series;
  std::vector<PlotLegend> legend;
};

// The axes reach from power of ten to power of ten. Throws std::invalid_argument when no point is positive
// and finite; single points that are not are left out.
Picture drawPlot(const Plot& plot, int width, int height);

}  // namespace room
