#include "materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "room/noise.h"

namespace room {
namespace {

using glm::dvec2;
using glm::dvec3;

double clamp01(double x) {
  return std::clamp(x, 0.0, 1.0);
}

// Metres from a point inside a cell of the given size to the cell's nearest edge.
double insetOf(dvec2 inCell, dvec2 size) {
  const dvec2 d = glm::min(inCell, size - inCell);
  return std::min(d.x, d.y);
}

}  // namespace

Texel brick(double u, double v) {
  constexpr int kColumns = 8;
  constexpr int kRows = 24;
  const dvec2 size = dvec2(kBrickExtent) / dvec2(kColumns, kRows);
  const double wobbleX = fractalNoise(u, v, 16, 32, 2, 11) * 0.007;
  const double wobbleY = fractalNoise(u, v, 24, 24, 2, 12) * 0.006;
  const double rowPosition = v * kRows + wobbleY / size.y;
  const int row = static_cast<int>(std::floor(rowPosition));
  const double columnPosition = u * kColumns + (row & 1) * 0.5 + wobbleX / size.x;
  const int column = static_cast<int>(std::floor(columnPosition));
  const int idX = ((column % kColumns) + kColumns) % kColumns;
  const int idY = ((row % kRows) + kRows) % kRows;
  const dvec2 inCell = dvec2(columnPosition - column, rowPosition - row) * size;

  const double grain = fractalNoise(u, v, 96, 96, 2, 21);
  const double inset = insetOf(inCell, size) + fractalNoise(u, v, 64, 64, 1, 22) * 0.006;
  const double body = smoothStep(0.004, 0.013, inset);

  // Fired unevenly: most are red, some orange, a few nearly black.
  const double fired = hash(idX, idY, 31);
  dvec3 color = glm::mix(dvec3(0.45, 0.20, 0.14), dvec3(0.63, 0.33, 0.21), fired);
  if (hash(idX, idY, 32) > 0.88) color = glm::mix(color, dvec3(0.20, 0.13, 0.12), 0.75);
  if (hash(idX, idY, 33) > 0.90) color = glm::mix(color, dvec3(0.72, 0.52, 0.38), 0.6);
  color *= 0.92 + 0.22 * grain + 0.18 * fractalNoise(u, v, 12, 24, 2, 34);

  // Old whitewash is left in patches.
  const double wash = smoothStep(0.12, 0.34, fractalNoise(u, v, 5, 4, 4, 35)) * 0.45;
  color = glm::mix(color, dvec3(0.78, 0.73, 0.66) * (0.9 + 0.3 * grain), wash);

  const dvec3 mortar = dvec3(0.50, 0.46, 0.41) * (0.82 + 0.5 * fractalNoise(u, v, 128, 128, 1, 36));
  const double tiltX = (hash(idX, idY, 37) - 0.5) * 0.06;
  const double tiltY = (hash(idX, idY, 38) - 0.5) * 0.10;
  Texel t;
  t.color = glm::mix(mortar * 0.8, color, body);
  t.height = body * (0.010 + tiltX * (inCell.x - size.x / 2) + tiltY * (inCell.y - size.y / 2) +
                     hash(idX, idY, 39) * 0.004) +
             grain * (0.0016 + 0.0012 * body) + fractalNoise(u, v, 40, 40, 1, 40) * 0.002;
  return t;
}

Texel checkerTiles(double u, double v) {
  constexpr int kTiles = 4;
  const dvec2 position = dvec2(u, v) * static_cast<double>(kTiles);
  const int column = static_cast<int>(std::floor(position.x));
  const int row = static_cast<int>(std::floor(position.y));
  const dvec2 size = dvec2(kTileExtent / kTiles);
  const dvec2 inCell = (position - dvec2(column, row)) * size;
  const double chip = fractalNoise(u, v, 24, 24, 3, 51);
  const double inset = insetOf(inCell, size) - smoothStep(0.28, 0.5, chip) * 0.012;
  const double body = smoothStep(0.003, 0.0075, inset);

  const bool dark = ((column + row) & 1) != 0;
  const double shade = 0.9 + 0.2 * hash(column, row, 52);
  const double cloud = fractalNoise(u + hash(column, row, 53), v + hash(column, row, 54), 8, 8, 4, 55);
  const double vein = std::exp(-std::abs(cloud) * 26.0);
  dvec3 color = dark ? glm::mix(dvec3(0.10, 0.115, 0.12), dvec3(0.34, 0.36, 0.35), vein * 0.55)
                     : glm::mix(dvec3(0.68, 0.62, 0.52), dvec3(0.46, 0.40, 0.33), vein * 0.6);
  color *= shade * (1.0 + 0.25 * cloud);

  const double dirt = smoothStep(-0.05, 0.45, fractalNoise(u, v, 6, 6, 4, 56));
  color = glm::mix(color, dvec3(0.25, 0.21, 0.16), dirt * (dark ? 0.25 : 0.45));
  const dvec3 grout = dvec3(0.21, 0.185, 0.16) * (0.9 + 0.5 * fractalNoise(u, v, 128, 128, 1, 57));

  Texel t;
  t.color = glm::mix(grout, color, body);
  const double tiltX = (hash(column, row, 58) - 0.5) * 0.012;
  const double tiltY = (hash(column, row, 59) - 0.5) * 0.012;
  t.height = body * (0.0045 + tiltX * (inCell.x - size.x / 2) + tiltY * (inCell.y - size.y / 2)) +
             (1 - body) * 0.001 * fractalNoise(u, v, 128, 128, 1, 60) +
             fractalNoise(u, v, 20, 20, 2, 61) * 0.0013;
  t.gloss = body;
  return t;
}

Texel plaster(double u, double v) {
  const double trowel = fractalNoise(u + 0.05 * fractalNoise(u, v, 4, 4, 2, 71), v, 10, 14, 5, 72);
  const double stain = smoothStep(0.05, 0.5, fractalNoise(u, v, 3, 3, 5, 73));
  const double crackLine = std::abs(fractalNoise(u, v, 4, 4, 5, 74));
  const double crack =
      (1 - smoothStep(0.0, 0.006, crackLine)) * smoothStep(0.0, 0.2, fractalNoise(u, v, 3, 3, 2, 75));
  Texel t;
  t.color = glm::mix(dvec3(0.66, 0.62, 0.55), dvec3(0.45, 0.37, 0.27), stain * 0.7) * (0.95 + 0.2 * trowel);
  t.color *= 1 - 0.5 * crack;
  t.height = trowel * 0.010 - crack * 0.003;
  return t;
}

Texel wood(double u, double v) {
  // u runs along the grain.
  const double bend = fractalNoise(u, v, 2, 6, 3, 81) * 0.09;
  const double rings = fractionOf((v + bend) * 14.0);
  const double late = smoothStep(0.2, 0.9, rings) * (1 - smoothStep(0.93, 1.0, rings));
  const double fibre = fractalNoise(u, v + bend * 0.3, 6, 160, 2, 82);
  const double tone = fractalNoise(u, v, 2, 4, 3, 83);
  Texel t;
  t.color = glm::mix(dvec3(0.56, 0.39, 0.23), dvec3(0.36, 0.22, 0.12), late * 0.8);
  t.color *= 0.92 + 0.35 * fibre + 0.30 * tone;
  const CellDistance knot = cellNoise(u, v, 2, 5, 84);
  const double dark = (1 - smoothStep(0.05, 0.16, knot.nearest)) * (knot.identity > 0.6 ? 1.0 : 0.0);
  t.color = glm::mix(t.color, dvec3(0.17, 0.10, 0.06), dark * 0.8);
  t.height = -late * 0.0008 + fibre * 0.0011 + tone * 0.002 - dark * 0.001;
  return t;
}

Texel paintedWood(double u, double v, dvec3 paint) {
  Texel t = wood(u, v);
  const double wear = fractalNoise(u, v, 5, 14, 5, 91);
  const double coat = 1 - smoothStep(0.20, 0.26, wear);
  t.color = glm::mix(t.color * 0.9, paint * (0.95 + 0.2 * fractalNoise(u, v, 6, 40, 3, 92)), coat);
  t.height = glm::mix(t.height, t.height * 0.5 + 0.0009, coat);
  return t;
}

Texel paintedMetal(double u, double v, dvec3 paint) {
  const double rust = smoothStep(0.16, 0.30, fractalNoise(u, v, 4, 4, 6, 101));
  const double speck = fractalNoise(u, v, 48, 48, 3, 102);
  Texel t;
  t.color = paint * (0.96 + 0.18 * fractalNoise(u, v, 6, 6, 4, 103));
  t.color = glm::mix(t.color, dvec3(0.34, 0.17, 0.08) * (1.0 + 0.7 * speck), rust);
  t.height = rust * (0.0006 + 0.0012 * speck) + fractalNoise(u, v, 12, 12, 2, 104) * 0.0005;
  t.gloss = clamp01((1 - 0.9 * rust) * (0.8 + 0.5 * fractalNoise(u, v, 16, 16, 4, 105)));
  return t;
}

Texel zinc(double u, double v, int crystalsX, int crystalsY) {
  const CellDistance crystal =
      cellNoise(u + 0.004 * noise(u * 60, v * 60, 60, 60, 111), v, crystalsX, crystalsY, 112);
  const double shade = 0.88 + 0.24 * crystal.identity;
  const double smudge = fractalNoise(u, v, 8, 6, 4, 113);
  const double rust = smoothStep(0.24, 0.42, fractalNoise(u, v, 8, 8, 5, 114));
  Texel t;
  t.color = dvec3(0.44, 0.46, 0.47) * shade * (1.0 + 0.35 * smudge);
  t.color = glm::mix(t.color, dvec3(0.38, 0.21, 0.11) * (1.0 + 0.6 * smudge), rust * 0.85);
  t.height = 0.0004 * crystal.identity + fractalNoise(u, v, 12, 9, 2, 115) * 0.0022 +
             rust * 0.0008 * noise(u * 256, v * 256, 256, 256, 116);
  t.gloss = clamp01((0.55 + 0.6 * crystal.identity) * (0.85 + 0.6 * smudge)) * (1 - 0.92 * rust);
  return t;
}

Texel paper(double u, double v) {
  const CellDistance fold = cellNoise(u, v, 5, 5, 121);
  Texel t;
  t.color = dvec3(0.93, 0.91, 0.85) * (0.97 + 0.08 * fractalNoise(u, v, 12, 12, 3, 122));
  const double rule = std::abs(fractionOf(v * 24) - 0.5);
  t.color = glm::mix(t.color, dvec3(0.45, 0.55, 0.75), 0.5 * (1 - smoothStep(0.05, 0.12, rule)));
  t.height = 0.005 * fold.nearest + 0.0015 * fractalNoise(u, v, 8, 8, 3, 123);
  return t;
}

Texel poster(double u, double v) {
  const double paperGrain = 1.0 + 0.08 * fractalNoise(u, v, 32, 48, 4, 131);
  const dvec3 night(0.075, 0.13, 0.20);
  const dvec3 dusk(0.80, 0.36, 0.17);
  const dvec3 cream(0.90, 0.82, 0.64);
  const dvec2 p((u - 0.5) * 0.7, v);  // the sheet is 0.7 as wide as it is high

  // Sky in flat bands, as if printed from few plates.
  const double band = std::floor(smoothStep(0.15, 0.95, 1.05 - v) * 6) / 6;
  dvec3 color = glm::mix(night, dusk, band);

  const auto beam = [&](dvec2 foot, double angle, double spread) {
    const dvec2 d = p - foot;
    const double off = std::atan2(d.x, d.y) - angle;
    return d.y > 0 ? 1 - smoothStep(spread - 0.006, spread, std::abs(off)) : 0.0;
  };
  const double left = beam({-0.22, 0.26}, 0.42, 0.10);
  const double right = beam({0.24, 0.22}, -0.36, 0.12);
  color = glm::mix(color, cream, 0.42 * left);
  color = glm::mix(color, dvec3(0.93, 0.68, 0.36), 0.45 * right);
  color = glm::mix(color, cream, 0.6 * left * right);

  const double moon = 1 - smoothStep(0.072, 0.074, glm::distance(p, dvec2(0.015, 0.775)));
  color = glm::mix(color, cream, moon);

  // Roofs: blocks of random height with lit windows.
  for (int layer = 0; layer < 2; ++layer) {
    const double scale = layer == 0 ? 17 : 11;
    const double x = u * scale + layer * 0.4;
    const int block = static_cast<int>(std::floor(x));
    const double top = (layer == 0 ? 0.27 : 0.17) + 0.13 * hash(block, layer, 132);
    if (v > top) continue;
    color = layer == 0 ? dvec3(0.11, 0.12, 0.17) : dvec3(0.045, 0.05, 0.075);
    const dvec2 window(fractionOf(fractionOf(x) * 4), fractionOf(v * 46));
    const int windowX = static_cast<int>(std::floor(x * 4));
    const int windowY = static_cast<int>(std::floor(v * 46));
    const bool pane = window.x > 0.3 && window.x < 0.7 && window.y > 0.25 && window.y < 0.75;
    if (pane && v < top - 0.015 && hash(windowX, windowY, 133 + static_cast<unsigned>(layer)) > 0.72) {
      color = dvec3(0.95, 0.75, 0.36);
    }
  }
  const bool margin = u < 0.05 || u > 0.95 || v < 0.035 || v > 0.965;
  if (margin) color = cream;

  Texel t;
  t.color = color * paperGrain;
  // Two folds from when it was posted, and damp waves.
  const double fold = std::min(std::abs(u - 0.5) * 0.7, std::abs(v - 0.5));
  t.color = glm::mix(dvec3(0.75, 0.70, 0.60), t.color, 0.75 + 0.25 * smoothStep(0.0, 0.004, fold));
  t.height = 0.004 * fractalNoise(u, v, 3, 4, 3, 134) + 0.0015 * smoothStep(0.0, 0.012, fold);
  return t;
}

}  // namespace room
