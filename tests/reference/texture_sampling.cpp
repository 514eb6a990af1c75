#include "tests/reference/texture_sampling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gen/ati.h"

namespace anteroom::reference {

namespace {

constexpr int64_t kBorder = -1;

// EXT_texture_mirror_clamp, section 3.8.7. A coordinate of 1 without a filter is the last texel.
double mirrored(double coordinate, int size, GLenum mode, bool linear) {
  const double half = 0.5 / size;
  const double away = std::max(half, std::abs(coordinate));
  switch (mode) {
    case gen::kMirrorClamp:
      return std::min(linear ? 1 : 1 - half, away);
    case gen::kMirrorClampToEdge:
      return std::min(1 - half, away);
    case gen::kMirrorClampToBorder:
      return std::min(1 + half, away);
    default:
      return coordinate;
  }
}

// Section 3.7.6, on texel numbers: exact, whatever the size of the coordinate.
int64_t wrap(int64_t i, int size, GLenum mode) {
  switch (mode) {
    case GL_REPEAT:
      return ((i % size) + size) % size;
    case GL_MIRRORED_REPEAT_OES: {
      const int64_t period = ((i % (2 * int64_t(size))) + 2 * int64_t(size)) % (2 * int64_t(size));
      return period < size ? period : 2 * int64_t(size) - 1 - period;
    }
    case gen::kMirrorClamp:
    case gen::kMirrorClampToBorder:
      return i < size ? std::max<int64_t>(i, 0) : kBorder;
    default:
      return std::clamp<int64_t>(i, 0, size - 1);  // GL_CLAMP_TO_EDGE, MIRROR_CLAMP_TO_EDGE
  }
}

// Coordinates far outside lose their fraction in any arithmetic; here they only must stay finite.
double bounded(double coordinate) {
  return std::isfinite(coordinate) ? std::clamp(coordinate, -1e12, 1e12) : 0.0;
}

struct Axis {
  int64_t lower, upper;
  double weight;  // of upper
};
Axis along(double coordinate, int size, GLenum mode, bool linear) {
  const double u = mirrored(bounded(coordinate), size, mode, linear) * size;
  if (!linear) {
    const int64_t i = wrap(static_cast<int64_t>(std::floor(u)), size, mode);
    return {i, i, 0};
  }
  const double below = std::floor(u - 0.5);
  const int64_t i = static_cast<int64_t>(below);
  return {wrap(i, size, mode), wrap(i + 1, size, mode), u - 0.5 - below};
}

glm::dvec4 texel(const StoredImage& image, int level, int64_t x, int64_t y, int64_t z) {
  if (x == kBorder || y == kBorder || z == kBorder) return glm::dvec4(0);
  return image.level(level)
      .color[image.index(level, static_cast<int>(x), static_cast<int>(y), static_cast<int>(z))];
}

glm::dvec4 sampleFlat(const StoredImage& image, const render::Sampler& sampler, int level, int layer,
                      const glm::dvec3& at, bool linear, bool volume) {
  const Level& l = image.level(level);
  const Axis x = along(at.x, l.width, sampler.wrapS, linear),
             y = along(at.y, l.height, sampler.wrapT, linear);
  const Axis z = volume ? along(at.z, l.depth, sampler.wrapR, linear) : Axis{layer, layer, 0};
  const auto slice = [&](int64_t k) {
    const glm::dvec4 lower = texel(image, level, x.lower, y.lower, k) * (1 - x.weight) +
                             texel(image, level, x.upper, y.lower, k) * x.weight;
    const glm::dvec4 upper = texel(image, level, x.lower, y.upper, k) * (1 - x.weight) +
                             texel(image, level, x.upper, y.upper, k) * x.weight;
    return lower * (1 - y.weight) + upper * y.weight;
  };
  return z.weight == 0 ? slice(z.lower) : slice(z.lower) * (1 - z.weight) + slice(z.upper) * z.weight;
}

// OES_texture_cube_map, table of major axes: face in the order +x -x +y -y +z -z, and s, t in [0, 1] on it.
struct FacePoint {
  int face;
  glm::dvec2 st;
};
glm::dvec3 onFace(int face, const glm::dvec3& r) {  // sc, tc, ma
  switch (face) {
    case 0:
      return {-r.z, -r.y, r.x};
    case 1:
      return {r.z, -r.y, -r.x};
    case 2:
      return {r.x, r.z, r.y};
    case 3:
      return {r.x, -r.z, -r.y};
    case 4:
      return {r.x, -r.y, r.z};
    default:
      return {-r.x, -r.y, -r.z};
  }
}
int majorFace(const glm::dvec3& r) {
  const glm::dvec3 a = glm::abs(r);
  if (a.x >= a.y && a.x >= a.z) return r.x >= 0 ? 0 : 1;
  if (a.y >= a.z) return r.y >= 0 ? 2 : 3;
  return r.z >= 0 ? 4 : 5;
}
glm::dvec2 facePoint(int face, const glm::dvec3& r) {
  const glm::dvec3 p = onFace(face, r);
  const double ma = p.z != 0 ? p.z : 1;
  return (glm::dvec2(p) / ma + 1.0) / 2.0;
}
glm::dvec3 direction(int face, const glm::dvec2& st) {  // the inverse of facePoint
  const double s = 2 * st.x - 1, t = 2 * st.y - 1;
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

glm::dvec4 sampleCube(const StoredImage& image, int level, const glm::dvec3& r, bool linear) {
  const int size = image.level(level).width;
  const int face = majorFace(r);
  const glm::dvec2 st = facePoint(face, r);
  if (!linear) {
    const Axis x = along(st.x, size, GL_CLAMP_TO_EDGE, false), y = along(st.y, size, GL_CLAMP_TO_EDGE, false);
    return texel(image, level, x.lower, y.lower, face);
  }
  const double u = st.x * size - 0.5, v = st.y * size - 0.5;
  const int64_t i = static_cast<int64_t>(std::floor(u)), j = static_cast<int64_t>(std::floor(v));
  const double a = u - std::floor(u), b = v - std::floor(v);
  glm::dvec4 sum(0);
  double weights = 0;
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const int64_t x = i + dx, y = j + dy;
      const double weight = (dx != 0 ? a : 1 - a) * (dy != 0 ? b : 1 - b);
      const bool xOut = x < 0 || x >= size, yOut = y < 0 || y >= size;
      if (xOut && yOut) continue;  // three faces meet here: the other three texels share the weight
      if (!xOut && !yOut) {
        sum += weight * texel(image, level, x, y, face);
      } else {
        const glm::dvec3 neighbour = direction(face, {(double(x) + 0.5) / size, (double(y) + 0.5) / size});
        sum += weight * sampleCube(image, level, neighbour, false);
      }
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights
                     : texel(image, level, std::clamp<int64_t>(i, 0, size - 1),
                             std::clamp<int64_t>(j, 0, size - 1), face);
}

// Equation 3.14: the larger of the two lengths that one pixel has in the texture.
double scaleFactor(const glm::dvec3& dx, const glm::dvec3& dy) {
  return std::max(glm::length(dx), glm::length(dy));
}

bool linearFilter(GLenum filter) {
  return filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST || filter == GL_LINEAR_MIPMAP_LINEAR;
}

}  // namespace

glm::dvec4 sampleTexture(const render::State& state, int unit, const Fragment& fragment) {
  const gen::TextureUnit& textureUnit = state.fixed.units[static_cast<size_t>(unit)];
  const render::TextureBinding& binding = state.textures[static_cast<size_t>(unit)];
  const StoredImage& image = static_cast<const StoredImage&>(*binding.image);
  const render::Sampler& sampler = binding.sampler;
  const bool part = binding.onlyLevel >= 0;
  const int first = part ? binding.onlyLevel : 0;
  const Level& base = image.level(first);
  const bool cube = textureUnit.target == gen::TextureTarget::CubeMap;
  const bool volume = textureUnit.target == gen::TextureTarget::Texture3D;
  const Fragment::Coordinate& coordinate = fragment.texCoord[static_cast<size_t>(unit)];

  const auto project = [&](const glm::dvec4& c) {
    return cube || c.w == 0 ? glm::dvec3(c) : glm::dvec3(c) / c.w;
  };
  const glm::dvec3 at = project(coordinate.center);
  const int face = majorFace(at);
  const glm::dvec3 size = cube ? glm::dvec3(base.width, base.height, 0)
                               : glm::dvec3(base.width, base.height, volume ? base.depth : 0);
  const auto inTexels = [&](const glm::dvec4& c) {
    const glm::dvec3 p = project(c);
    return cube ? glm::dvec3(facePoint(face, p), 0) * size : p * size;
  };

  double lambda = 0;
  if (!fragment.constantCoordinates) {
    const double rho = scaleFactor(inTexels(coordinate.right) - inTexels(coordinate.left),
                                   inTexels(coordinate.above) - inTexels(coordinate.below));
    lambda = rho > 0 ? std::log2(rho) : -HUGE_VAL;
  }
  lambda += double(textureUnit.env.lodBias);

  const auto filtered = [&](int level, bool linear) {
    return cube ? sampleCube(image, level, at, linear)
                : sampleFlat(image, sampler, level, part ? binding.onlyLayer : 0, at, linear, volume);
  };
  const bool mipmapped = sampler.minFilter != GL_NEAREST && sampler.minFilter != GL_LINEAR;
  const bool nearestMin =
      sampler.minFilter == GL_NEAREST_MIPMAP_NEAREST || sampler.minFilter == GL_NEAREST_MIPMAP_LINEAR;
  const double c = sampler.magFilter == GL_LINEAR && nearestMin ? 0.5 : 0.0;  // section 3.7.8
  if (!(lambda > c)) return filtered(first, sampler.magFilter == GL_LINEAR);
  const bool linear = linearFilter(sampler.minFilter);
  if (!mipmapped || part) return filtered(first, linear);

  const int last = std::min(image.levelCount() - 1, sampler.maxLevel);
  const double q = last;
  if (sampler.minFilter == GL_NEAREST_MIPMAP_NEAREST || sampler.minFilter == GL_LINEAR_MIPMAP_NEAREST) {
    const int level = lambda <= 0.5      ? 0
                      : lambda > q + 0.5 ? last
                                         : static_cast<int>(std::ceil(lambda + 0.5)) - 1;
    return filtered(level, linear);
  }
  const double level = std::clamp(lambda, 0.0, q);
  const int lower = static_cast<int>(std::floor(level)), upper = std::min(lower + 1, last);
  const double fraction = level - lower;
  return filtered(lower, linear) * (1 - fraction) + filtered(upper, linear) * fraction;
}

}  // namespace anteroom::reference
