// Sections 3.3 to 3.5: from clipped primitives to fragments.
#pragma once

#include <functional>
#include <vector>

#include "tests/reference/vertex_processing.h"

namespace anteroom::reference {

struct Fragment {
  int x = 0, y = 0;           // pixel, GL's window coordinates
  uint32_t samples = 1;       // bit s: sample s is covered
  double coverage = 1;        // of smooth points and lines
  std::array<double, 4> z{};  // window depth a sample, before it is rounded
  glm::dvec4 color{0};
  double fogDistance = 0;
  // Texture coordinates at the pixel's center, and half a pixel to either side in x and y.
  struct Coordinate {
    glm::dvec4 center{0}, left{0}, right{0}, below{0}, above{0};
  };
  std::array<Coordinate, gen::kMaxTextureUnits> texCoord{};
  bool constantCoordinates = false;  // points: the scale factor is 1 (section 3.7.7)
};

using EmitFragment = std::function<void(const Fragment&)>;

// One primitive of 1, 2 or 3 vertices, clipped and in window coordinates, ready to be rasterised row by row.
struct WindowVertex {
  glm::dvec3 window{0};  // x, y in pixels, z in [0, 1]
  double inverseW = 1;
  Vertex vertex;
};

struct WindowPrimitive {
  std::vector<WindowVertex> vertices;
  bool frontFacing = true;
  int firstRow = 0, lastRow = -1;  // inclusive
};

class Rasteriser {
 public:
  explicit Rasteriser(const render::State& state);

  // Clips and transforms; appends what is left to `out`: a triangle may become several.
  void add(const std::vector<Vertex>& primitive, std::vector<WindowPrimitive>& out) const;
  // The fragments in rows [fromRow, toRow).
  void rasterise(const WindowPrimitive& primitive, int fromRow, int toRow, const EmitFragment& emit) const;

 private:
  WindowVertex toWindow(const Vertex& vertex) const;
  void addTriangle(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c,
                   std::vector<WindowPrimitive>& out) const;
  void triangle(const WindowPrimitive& primitive, int fromRow, int toRow, const EmitFragment& emit) const;
  void line(const WindowPrimitive& primitive, int fromRow, int toRow, const EmitFragment& emit) const;
  void smoothLine(const WindowPrimitive& primitive, int fromRow, int toRow, const EmitFragment& emit) const;
  void point(const WindowPrimitive& primitive, int fromRow, int toRow, const EmitFragment& emit) const;
  void interpolateLine(const WindowPrimitive& primitive, double x, double y, Fragment& fragment) const;

  const render::State& state_;
  render::Rect bounds_;  // framebuffer and scissor
  int samples_ = 1;
};

}  // namespace anteroom::reference
