#include "tests/reference/rasterisation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "layer/render/renderer.h"
#include "tests/reference/clipping.h"

namespace anteroom::reference {

using gen::kMaxTextureUnits;
using gen::PrimitiveClass;

namespace {

// Section 3.5.2: the smallest difference between depths that the buffer resolves. Of floats, it depends on
// the depth.
double depthStep(const render::Framebuffer& framebuffer, double highest) {
  if (framebuffer.depth.image == nullptr) return std::ldexp(1.0, -24);
  const render::Format format = framebuffer.depth.image->desc().format;
  if (format == render::Format::Depth32) return highest > 0 ? std::ldexp(1.0, std::ilogb(highest) - 23) : 0;
  return std::ldexp(1.0, -render::info(format).depth);
}

constexpr double kSubpixels = 256;  // Vulkan's subPixelPrecisionBits = 8

struct SamplePosition {
  double x, y;
};
// Vulkan's standard positions; y as memory rows go.
constexpr SamplePosition kOneSample[] = {{0.5, 0.5}};
constexpr SamplePosition kFourSamples[] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};

int clampToInt(double value, int low, int high) {
  return static_cast<int>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

render::Rect intersect(const render::Rect& a, const render::Rect& b) {
  const int x0 = std::max(a.x, b.x), y0 = std::max(a.y, b.y);
  const int64_t x1 = std::min(int64_t(a.x) + a.width, int64_t(b.x) + b.width);
  const int64_t y1 = std::min(int64_t(a.y) + a.height, int64_t(b.y) + b.height);
  return {x0, y0, static_cast<int>(std::max<int64_t>(0, x1 - x0)),
          static_cast<int>(std::max<int64_t>(0, y1 - y0))};
}

struct Snapped {
  int64_t x, y;
};
Snapped snap(const WindowVertex& v) {
  return {std::llround(v.window.x * kSubpixels), std::llround(v.window.y * kSubpixels)};
}

int64_t cross(const Snapped& o, const Snapped& a, const Snapped& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

double cross(const glm::dvec3& o, const glm::dvec3& a, double x, double y) {
  return (a.x - o.x) * (y - o.y) - (a.y - o.y) * (x - o.x);
}

// Barycentric weights on the screen, from exact positions.
class Barycentric {
 public:
  Barycentric(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
      : a_(a), b_(b), c_(c), area_(cross(a, b, c.x, c.y)) {}
  bool degenerate() const { return area_ == 0; }
  glm::dvec3 at(double x, double y) const {
    if (degenerate()) return {1, 0, 0};
    return glm::dvec3(cross(b_, c_, x, y), cross(c_, a_, x, y), cross(a_, b_, x, y)) / area_;
  }

 private:
  glm::dvec3 a_, b_, c_;
  double area_;
};

// Weights for attributes: equation 3.6.
glm::dvec3 perspective(const glm::dvec3& screen, const std::vector<WindowVertex>& v) {
  const glm::dvec3 w(screen.x * v[0].inverseW, screen.y * v[1].inverseW, screen.z * v[2].inverseW);
  const double sum = w.x + w.y + w.z;
  return sum != 0 ? w / sum : screen;
}

// The part of a unit square at (x, y) that lies inside a convex polygon.
double coveredArea(std::vector<glm::dvec2> polygon, double x, double y) {
  const auto clip = [&polygon](double nx, double ny, double limit) {  // keeps nx*px + ny*py <= limit
    std::vector<glm::dvec2> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const double da = limit - (nx * a.x + ny * a.y), db = limit - (nx * b.x + ny * b.y);
      if (da >= 0) kept.push_back(a);
      if ((da >= 0) != (db >= 0)) kept.push_back(a + (b - a) * (da / (da - db)));
    }
    polygon = std::move(kept);
  };
  clip(-1, 0, -x);
  clip(1, 0, x + 1);
  clip(0, -1, -y);
  clip(0, 1, y + 1);
  double area = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return std::abs(area) / 2;
}

// The part of the unit square at (0, 0) that lies inside a circle, by columns.
double coveredByCircle(const glm::dvec2& center, double radius) {
  constexpr int kColumns = 512;
  double area = 0;
  for (int i = 0; i < kColumns; ++i) {
    const double x = (i + 0.5) / kColumns - center.x, squared = radius * radius - x * x;
    if (squared <= 0) continue;
    const double half = std::sqrt(squared);
    area += std::max(0.0, std::min(1.0, center.y + half) - std::max(0.0, center.y - half)) / kColumns;
  }
  return area;
}

}  // namespace

Rasteriser::Rasteriser(const render::State& state) : state_(state) {
  bounds_ = {0, 0, state.framebuffer.width, state.framebuffer.height};
  if (state.scissorTest) bounds_ = intersect(bounds_, state.scissor);
  samples_ = state.framebuffer.samples;
}

// Section 2.10.1.
WindowVertex Rasteriser::toWindow(const Vertex& vertex) const {
  const render::Rect& view = state_.fixed.viewport;
  const double n = std::clamp<double>(state_.depthNear, 0, 1), f = std::clamp<double>(state_.depthFar, 0, 1);
  WindowVertex result;
  result.vertex = vertex;
  result.inverseW = 1 / vertex.clip.w;
  const glm::dvec3 ndc = glm::dvec3(vertex.clip) * result.inverseW;
  result.window = {view.width / 2.0 * ndc.x + (view.x + view.width / 2.0),
                   view.height / 2.0 * ndc.y + (view.y + view.height / 2.0),
                   (f - n) / 2 * ndc.z + (n + f) / 2};
  return result;
}

void Rasteriser::addTriangle(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c,
                             std::vector<WindowPrimitive>& out) const {
  const int64_t area = cross(snap(a), snap(b), snap(c));
  if (area == 0) return;
  WindowPrimitive primitive;
  primitive.frontFacing = (area > 0) == (state_.raster.frontFace == GL_CCW);
  if (state_.raster.cullFace) {  // section 3.5.1
    const GLenum mode = state_.raster.cullFaceMode;
    if (mode == GL_FRONT_AND_BACK || (mode == GL_FRONT) == primitive.frontFacing) return;
  }
  primitive.vertices = area > 0 ? std::vector{a, b, c} : std::vector{a, c, b};
  const auto [low, high] = std::minmax({a.window.y, b.window.y, c.window.y});
  primitive.firstRow = clampToInt(std::floor(low) - 1, -1, state_.framebuffer.height);
  primitive.lastRow = clampToInt(std::ceil(high) + 1, -1, state_.framebuffer.height);
  out.push_back(std::move(primitive));
}

void Rasteriser::add(const std::vector<Vertex>& primitive, std::vector<WindowPrimitive>& out) const {
  std::vector<Vertex> vertices = primitive;
  if (state_.fixed.shadeModel == GL_FLAT) {  // section 2.12.6: the last vertex provokes
    for (Vertex& v : vertices) {
      v.front = vertices.back().front;
      v.back = vertices.back().back;
    }
  }
  const int height = state_.framebuffer.height;
  if (vertices.size() == 3) {
    const std::vector<Vertex> polygon = clipPolygon(std::move(vertices), state_.fixed);
    for (size_t i = 1; i + 1 < polygon.size(); ++i)
      addTriangle(toWindow(polygon[0]), toWindow(polygon[i]), toWindow(polygon[i + 1]), out);
    return;
  }
  WindowPrimitive result;
  double reach = 0;
  if (vertices.size() == 2) {
    if (!clipLine(vertices[0], vertices[1], state_.fixed)) return;
    reach = state_.raster.lineWidth;
  } else {
    if (!pointIsVisible(vertices[0], state_.fixed)) return;
    reach = vertices[0].pointSize;
  }
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vertex& v : vertices) {
    result.vertices.push_back(toWindow(v));
    low = std::min(low, result.vertices.back().window.y);
    high = std::max(high, result.vertices.back().window.y);
  }
  result.firstRow = clampToInt(std::floor(low - reach) - 1, -1, height);
  result.lastRow = clampToInt(std::ceil(high + reach) + 1, -1, height);
  out.push_back(std::move(result));
}

void Rasteriser::rasterise(const WindowPrimitive& primitive, int fromRow, int toRow,
                           const EmitFragment& emit) const {
  fromRow = std::max({fromRow, bounds_.y, primitive.firstRow});
  toRow = std::min({toRow, bounds_.y + bounds_.height, primitive.lastRow + 1});
  if (fromRow >= toRow) return;
  switch (primitive.vertices.size()) {
    case 3:
      triangle(primitive, fromRow, toRow, emit);
      break;
    case 2:
      if (state_.fixed.lineSmooth || state_.fixed.multisample)
        smoothLine(primitive, fromRow, toRow, emit);
      else
        line(primitive, fromRow, toRow, emit);
      break;
    default:
      point(primitive, fromRow, toRow, emit);
  }
}

void Rasteriser::triangle(const WindowPrimitive& primitive, int fromRow, int toRow,
                          const EmitFragment& emit) const {
  const std::vector<WindowVertex>& v = primitive.vertices;  // counter-clockwise
  const Snapped corner[3] = {snap(v[0]), snap(v[1]), snap(v[2])};
  const bool yDown = state_.framebuffer.yDown;
  const int height = state_.framebuffer.height;

  // Vulkan's top-left rule. In window coordinates with y up, "top" is the lower side when memory runs
  // bottom-up.
  int64_t bias[3];
  for (int i = 0; i < 3; ++i) {
    const Snapped& a = corner[(i + 1) % 3];
    const Snapped& b = corner[(i + 2) % 3];
    const bool left = b.y < a.y;
    const bool top = a.y == b.y && (yDown ? b.x < a.x : b.x > a.x);
    bias[i] = left || top ? 0 : -1;
  }
  const auto inside = [&](double x, double y) {
    const Snapped p{std::llround(x * kSubpixels), std::llround(y * kSubpixels)};
    for (int i = 0; i < 3; ++i)
      if (cross(corner[(i + 1) % 3], corner[(i + 2) % 3], p) + bias[i] < 0) return false;
    return true;
  };

  const Barycentric barycentric(v[0].window, v[1].window, v[2].window);
  const auto depthAt = [&](double x, double y) {
    const glm::dvec3 weight = barycentric.at(x, y);
    return weight.x * v[0].window.z + weight.y * v[1].window.z + weight.z * v[2].window.z;
  };
  const auto weights = [&](double x, double y) { return perspective(barycentric.at(x, y), v); };

  double offset = 0;  // section 3.5.2
  if (state_.raster.polygonOffsetFill && !barycentric.degenerate()) {
    const double slopeX = depthAt(1, 0) - depthAt(0, 0), slopeY = depthAt(0, 1) - depthAt(0, 0);
    const double highest = std::max({v[0].window.z, v[1].window.z, v[2].window.z});
    offset = std::max(std::abs(slopeX), std::abs(slopeY)) * double(state_.raster.polygonOffsetFactor) +
             depthStep(state_.framebuffer, highest) * double(state_.raster.polygonOffsetUnits);
    const double most = double(state_.raster.polygonOffsetClamp);  // EXT_polygon_offset_clamp
    if (most > 0) offset = std::min(offset, most);
    if (most < 0) offset = std::max(offset, most);
  }

  // Clipping left a margin around the view volume (clipping.h); the viewport ends it.
  const render::Rect visible = intersect(bounds_, state_.fixed.viewport);
  fromRow = std::max(fromRow, visible.y);
  toRow = std::min(toRow, visible.y + visible.height);
  const auto [minX, maxX] = std::minmax({v[0].window.x, v[1].window.x, v[2].window.x});
  const int fromX = clampToInt(std::floor(minX) - 1, visible.x, visible.x + visible.width);
  const int toX = clampToInt(std::ceil(maxX) + 2, visible.x, visible.x + visible.width);
  const SamplePosition* positions = samples_ == 4 ? kFourSamples : kOneSample;
  const bool perSample = state_.fixed.multisample;

  for (int y = fromRow; y < toRow; ++y) {
    for (int x = fromX; x < toX; ++x) {
      Fragment fragment;
      fragment.samples = 0;
      for (int s = 0; s < samples_; ++s) {
        const SamplePosition at = perSample ? positions[s] : kOneSample[0];
        const double sy = yDown ? height - (height - 1 - y + at.y) : y + at.y;
        if (!inside(x + at.x, sy)) continue;
        fragment.samples |= 1u << s;
        fragment.z[static_cast<size_t>(s)] = std::clamp(depthAt(x + at.x, sy) + offset, 0.0, 1.0);
      }
      if (fragment.samples == 0) continue;
      fragment.x = x;
      fragment.y = y;
      const double cx = x + 0.5, cy = y + 0.5;
      const glm::dvec3 w = weights(cx, cy);
      const auto color = [&](const WindowVertex& p) {
        return primitive.frontFacing ? p.vertex.front : p.vertex.back;
      };
      fragment.color = w.x * color(v[0]) + w.y * color(v[1]) + w.z * color(v[2]);
      fragment.fogDistance =
          w.x * v[0].vertex.fogDistance + w.y * v[1].vertex.fogDistance + w.z * v[2].vertex.fogDistance;
      const glm::dvec3 wl = weights(cx - 0.5, cy), wr = weights(cx + 0.5, cy);
      const glm::dvec3 wb = weights(cx, cy - 0.5), wa = weights(cx, cy + 0.5);
      for (size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
        if (state_.fixed.units[unit].target == gen::TextureTarget::None) continue;
        const auto at = [&](const glm::dvec3& weight) {
          return weight.x * v[0].vertex.texCoord[unit] + weight.y * v[1].vertex.texCoord[unit] +
                 weight.z * v[2].vertex.texCoord[unit];
        };
        fragment.texCoord[unit] = {at(w), at(wl), at(wr), at(wb), at(wa)};
      }
      emit(fragment);
    }
  }
}

// Equations 3.4 and 3.5 at the projection of (x, y) onto the segment.
void Rasteriser::interpolateLine(const WindowPrimitive& primitive, double x, double y,
                                 Fragment& fragment) const {
  const WindowVertex& a = primitive.vertices[0];
  const WindowVertex& b = primitive.vertices[1];
  const glm::dvec2 from(a.window), direction = glm::dvec2(b.window) - from;
  const double squared = glm::dot(direction, direction);
  const auto parameter = [&](double px, double py) {
    return squared > 0 ? glm::dot(glm::dvec2(px, py) - from, direction) / squared : 0.0;
  };
  const auto weight = [&](double t) {
    const double wa = (1 - t) * a.inverseW, wb = t * b.inverseW;
    return wa + wb != 0 ? wb / (wa + wb) : t;
  };
  const double t = std::clamp(parameter(x, y), 0.0, 1.0), w = weight(t);
  fragment.z.fill(std::clamp(a.window.z * (1 - t) + b.window.z * t, 0.0, 1.0));
  fragment.color = a.vertex.front * (1 - w) + b.vertex.front * w;
  fragment.fogDistance = a.vertex.fogDistance * (1 - w) + b.vertex.fogDistance * w;
  for (size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (state_.fixed.units[unit].target == gen::TextureTarget::None) continue;
    const auto at = [&](double px, double py) {
      const double k = weight(parameter(px, py));
      return a.vertex.texCoord[unit] * (1 - k) + b.vertex.texCoord[unit] * k;
    };
    fragment.texCoord[unit] = {a.vertex.texCoord[unit] * (1 - w) + b.vertex.texCoord[unit] * w,
                               at(x - 0.5, y), at(x + 0.5, y), at(x, y - 0.5), at(x, y + 0.5)};
  }
}

// Section 3.4.1: the diamond-exit rule, replicated in the minor direction for wide lines (section 3.4.2).
void Rasteriser::line(const WindowPrimitive& primitive, int fromRow, int toRow,
                      const EmitFragment& emit) const {
  glm::dvec2 a(primitive.vertices[0].window), b(primitive.vertices[1].window);
  const bool xMajor = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  const int width = std::max(1, static_cast<int>(std::floor(double(state_.raster.lineWidth) + 0.5)));
  const int major = xMajor ? 0 : 1, minor = 1 - major;
  a[minor] -= (width - 1) / 2.0;
  b[minor] -= (width - 1) / 2.0;
  // Both ends are perturbed by (e, e^2), which decides for segments along the corners of the diamonds.
  constexpr double kEpsilon = 1e-6;
  const glm::dvec2 perturbation(kEpsilon, kEpsilon * kEpsilon);
  a -= perturbation;
  b -= perturbation;

  // Does the segment leave the open diamond around the pixel's center?
  const auto exits = [&](const glm::dvec2& center) {
    const glm::dvec2 p = a - center, q = b - center;
    if (std::abs(q.x) + std::abs(q.y) < 0.5) return false;
    double from = 0, to = 1;
    for (int sx = -1; sx <= 1; sx += 2) {
      for (int sy = -1; sy <= 1; sy += 2) {
        const double dp = 0.5 - (sx * p.x + sy * p.y), dq = 0.5 - (sx * q.x + sy * q.y);
        if (dp <= 0 && dq <= 0) return false;
        if (dp < 0) from = std::max(from, dp / (dp - dq));
        if (dq < 0) to = std::min(to, dp / (dp - dq));
      }
    }
    return from < to;
  };

  const double slope = b[major] != a[major] ? (b[minor] - a[minor]) / (b[major] - a[major]) : 0;
  const int limit = std::max(state_.framebuffer.width, state_.framebuffer.height) + 1;
  const int first = clampToInt(std::floor(std::min(a[major], b[major])), -1, limit);
  const int last = clampToInt(std::floor(std::max(a[major], b[major])), -1, limit);
  for (int i = first; i <= last; ++i) {
    const int middle = static_cast<int>(std::floor(a[minor] + slope * (i + 0.5 - a[major])));
    for (int j = middle - 1; j <= middle + 1; ++j) {
      glm::dvec2 center;
      center[major] = i + 0.5;
      center[minor] = j + 0.5;
      if (!exits(center)) continue;
      Fragment fragment;
      fragment.samples = (1u << samples_) - 1;
      glm::dvec2 onSegment = center;
      onSegment[minor] += (width - 1) / 2.0;
      interpolateLine(primitive, onSegment.x, onSegment.y, fragment);
      for (int k = 0; k < width; ++k) {
        fragment.x = xMajor ? i : j + k;
        fragment.y = xMajor ? j + k : i;
        if (fragment.x >= bounds_.x && fragment.x < bounds_.x + bounds_.width && fragment.y >= fromRow &&
            fragment.y < toRow)
          emit(fragment);
      }
    }
  }
}

// Section 3.4.2, antialiasing: coverage of a rectangle as long as the segment; section 3.4.4 with samples.
void Rasteriser::smoothLine(const WindowPrimitive& primitive, int fromRow, int toRow,
                            const EmitFragment& emit) const {
  const glm::dvec2 a(primitive.vertices[0].window), b(primitive.vertices[1].window);
  const double length = glm::length(b - a);
  if (!(length > 0)) return;
  const glm::dvec2 along = (b - a) / length;
  const glm::dvec2 across = glm::dvec2(-along.y, along.x) * (double(state_.raster.lineWidth) / 2);
  const std::vector<glm::dvec2> rectangle{a - across, b - across, b + across, a + across};
  const bool perSample = state_.fixed.multisample;
  const bool yDown = state_.framebuffer.yDown;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const glm::dvec2& corner : rectangle) {
    low = std::min(low, corner.x);
    high = std::max(high, corner.x);
  }
  const int fromX = clampToInt(std::floor(low) - 1, bounds_.x, bounds_.x + bounds_.width);
  const int toX = clampToInt(std::ceil(high) + 1, bounds_.x, bounds_.x + bounds_.width);
  for (int y = fromRow; y < toRow; ++y) {
    for (int x = fromX; x < toX; ++x) {
      Fragment fragment;
      fragment.samples = (1u << samples_) - 1;
      if (perSample) {
        fragment.samples = 0;
        for (int s = 0; s < samples_; ++s) {
          const glm::dvec2 p(x + kFourSamples[s].x,
                             yDown ? y + 1 - kFourSamples[s].y : y + kFourSamples[s].y);
          const double t = glm::dot(p - a, along),
                       d = std::abs(glm::dot(p - a, glm::dvec2(-along.y, along.x)));
          if (t >= 0 && t < length && d <= double(state_.raster.lineWidth) / 2) fragment.samples |= 1u << s;
        }
        if (fragment.samples == 0) continue;
      } else {
        fragment.coverage = coveredArea(rectangle, x, y);
        if (!(fragment.coverage > 0)) continue;
      }
      fragment.x = x;
      fragment.y = y;
      interpolateLine(primitive, x + 0.5, y + 0.5, fragment);
      emit(fragment);
    }
  }
}

// Section 3.3.1.
void Rasteriser::point(const WindowPrimitive& primitive, int fromRow, int toRow,
                       const EmitFragment& emit) const {
  const WindowVertex& v = primitive.vertices[0];
  const gen::Points& points = state_.fixed.points;
  const bool perSample = state_.fixed.multisample;
  const bool yDown = state_.framebuffer.yDown;
  const bool round = !points.sprite && (points.smooth || perSample);
  glm::dvec2 center(v.window);
  double size = v.vertex.pointSize;
  double alpha = 1;
  if (perSample && size < double(points.fadeThreshold)) {  // equation 3.2
    alpha = (size / double(points.fadeThreshold)) * (size / double(points.fadeThreshold));
    size = points.fadeThreshold;
  }
  if (!points.sprite && !round) {
    size = std::max(1.0, std::floor(size + 0.5));
    const bool odd = std::fmod(size, 2) == 1;
    center = glm::floor(center * double(kSubpixels) + 0.5) / double(kSubpixels);
    center = odd ? glm::floor(center) + 0.5 : glm::floor(center + 0.5);
  }
  const double radius = size / 2;

  const auto inside = [&](double x, double y) {
    if (round) return (x - center.x) * (x - center.x) + (y - center.y) * (y - center.y) <= radius * radius;
    const bool inY = yDown ? y > center.y - radius && y <= center.y + radius
                           : y >= center.y - radius && y < center.y + radius;
    return x >= center.x - radius && x < center.x + radius && inY;
  };

  const int fromX = clampToInt(std::floor(center.x - radius) - 1, bounds_.x, bounds_.x + bounds_.width);
  const int toX = clampToInt(std::ceil(center.x + radius) + 1, bounds_.x, bounds_.x + bounds_.width);
  for (int y = fromRow; y < toRow; ++y) {
    for (int x = fromX; x < toX; ++x) {
      Fragment fragment;
      fragment.samples = (1u << samples_) - 1;
      fragment.coverage = alpha;
      if (perSample) {
        fragment.samples = 0;
        for (int s = 0; s < samples_; ++s)
          if (inside(x + kFourSamples[s].x, yDown ? y + 1 - kFourSamples[s].y : y + kFourSamples[s].y))
            fragment.samples |= 1u << s;
        if (fragment.samples == 0) continue;
      } else if (round) {
        fragment.coverage = coveredByCircle(center - glm::dvec2(x, y), radius);
        if (fragment.coverage == 0) continue;
      } else if (!inside(x + 0.5, y + 0.5)) {
        continue;
      }
      fragment.x = x;
      fragment.y = y;
      fragment.z.fill(std::clamp(v.window.z, 0.0, 1.0));
      fragment.color = v.vertex.front;
      fragment.fogDistance = v.vertex.fogDistance;
      fragment.constantCoordinates = true;
      for (size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
        glm::dvec4 coordinate = v.vertex.texCoord[unit];
        if (points.sprite && state_.fixed.units[unit].env.coordReplace)
          coordinate = {0.5 + (x + 0.5 - v.window.x) / size, 0.5 - (y + 0.5 - v.window.y) / size, 0, 1};
        fragment.texCoord[unit] = {coordinate, coordinate, coordinate, coordinate, coordinate};
      }
      emit(fragment);
    }
  }
}

}  // namespace anteroom::reference
