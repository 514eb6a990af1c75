#include "image.h"

#include <OpenImageIO/parallel.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace room {
namespace {

const float* rowOf(const Image& image, int y) {
  return static_cast<const float*>(image.pixeladdr(0, y));
}
float* rowOf(Image& image, int y) {
  return static_cast<float*>(image.pixeladdr(0, y));
}

Image makeImage(int width, int height, int channels) {
  return Image(OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::FLOAT), OIIO::InitializePixels::No);
}

void forEachRow(int height, const std::function<void(int y)>& f) {
  OIIO::parallel_for_chunked(0, height, 16, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t y = begin; y < end; ++y) f(static_cast<int>(y));
  });
}

// Central differences with wrap-around: rise a texel along u and along v.
glm::dvec2 rise(const Image& height, int x, int y) {
  const int w = height.spec().width;
  const int h = height.spec().height;
  const float* row = rowOf(height, y);
  return {(row[(x + 1) % w] - row[(x + w - 1) % w]) * 0.5,
          (rowOf(height, (y + 1) % h)[x] - rowOf(height, (y + h - 1) % h)[x]) * 0.5};
}

void storeNormal(glm::dvec3 n, float* out) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(n[i] * 0.5 + 0.5);
}

}  // namespace

BakedTexels bake(int width, int height, const TexelFunction& texel) {
  BakedTexels baked{makeImage(width, height, 3), makeImage(width, height, 1), makeImage(width, height, 1)};
  forEachRow(height, [&](int y) {
    float* color = rowOf(baked.color, y);
    float* rise = rowOf(baked.height, y);
    float* gloss = rowOf(baked.gloss, y);
    for (int x = 0; x < width; ++x) {
      const Texel t = texel((x + 0.5) / width, (y + 0.5) / height);
      for (int i = 0; i < 3; ++i) color[3 * x + i] = static_cast<float>(t.color[i]);
      rise[x] = static_cast<float>(t.height);
      gloss[x] = static_cast<float>(t.gloss);
    }
  });
  return baked;
}

Image generate(int width, int height, int channels, const std::function<void(double, double, float*)>& f) {
  Image image = makeImage(width, height, channels);
  forEachRow(height, [&](int y) {
    float* row = rowOf(image, y);
    for (int x = 0; x < width; ++x) f((x + 0.5) / width, (y + 0.5) / height, row + channels * x);
  });
  return image;
}

Image tangentNormals(const Image& height, glm::dvec2 extent) {
  const int w = height.spec().width;
  const int h = height.spec().height;
  Image normals = makeImage(w, h, 3);
  forEachRow(h, [&](int y) {
    float* out = rowOf(normals, y);
    for (int x = 0; x < w; ++x) {
      const glm::dvec2 slope = rise(height, x, y) * glm::dvec2(w, h) / extent;
      storeNormal(glm::normalize(glm::dvec3(-slope, 1.0)), out + 3 * x);
    }
  });
  return normals;
}

Image objectNormals(const Image& height, const SurfaceFunction& point) {
  const int w = height.spec().width;
  const int h = height.spec().height;
  // The surface at every texel centre once; its slopes come from the neighbours, as those of the height do.
  std::vector<glm::dvec3> points(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  const auto pointAt = [&](int x, int y) -> glm::dvec3& {
    return points[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)];
  };
  forEachRow(h, [&](int y) {
    for (int x = 0; x < w; ++x) pointAt(x, y) = point((x + 0.5) / w, (y + 0.5) / h);
  });
  Image normals = makeImage(w, h, 3);
  forEachRow(h, [&](int y) {
    float* out = rowOf(normals, y);
    const int below = std::max(y - 1, 0);
    const int above = std::min(y + 1, h - 1);
    for (int x = 0; x < w; ++x) {
      const glm::dvec3 du = (pointAt((x + 1) % w, y) - pointAt((x + w - 1) % w, y)) * 0.5;
      const glm::dvec3 dv = (pointAt(x, above) - pointAt(x, below)) / static_cast<double>(above - below);
      const double texelU = glm::length(du);
      const double texelV = glm::length(dv);
      const glm::dvec3 normal = glm::normalize(glm::cross(du, dv));
      const glm::dvec2 step = rise(height, x, y);
      storeNormal(
          glm::normalize(normal - du * (step.x / (texelU * texelU)) - dv * (step.y / (texelV * texelV))),
          out + 3 * x);
    }
  });
  return normals;
}

Image halved(const Image& image) {
  const OIIO::ImageSpec& spec = image.spec();
  const int channels = spec.nchannels;
  Image half = makeImage(std::max(1, spec.width / 2), std::max(1, spec.height / 2), channels);
  const int right = spec.width > 1 ? channels : 0;
  for (int y = 0; y < half.spec().height; ++y) {
    const float* low = rowOf(image, std::min(2 * y, spec.height - 1));
    const float* high = rowOf(image, std::min(2 * y + 1, spec.height - 1));
    float* out = rowOf(half, y);
    for (int x = 0; x < half.spec().width; ++x) {
      for (int c = 0; c < channels; ++c) {
        const int i = 2 * x * channels + c;
        out[x * channels + c] = (low[i] + low[i + right] + high[i] + high[i + right]) * 0.25F;
      }
    }
  }
  return half;
}

}  // namespace room
