#include "image.h"

#include <OpenImageIO/parallel.h>

#include <cmath>

namespace room {
namespace {

const float* rowOf(const Image& image, int y) { return static_cast<const float*>(image.pixeladdr(0, y)); }
float* rowOf(Image& image, int y) { return static_cast<float*>(image.pixeladdr(0, y)); }

Image makeImage(int width, int height, int channels) {
  return Image(OIIO::ImageSpec(width, height, channels, OIIO::TypeDesc::FLOAT));
}

void forEachRow(int height, const std::function<void(int y)>& f) {
  OIIO::parallel_for(0, height, [&](std::int64_t y) { f(static_cast<int>(y)); });
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
  Image normals = makeImage(w, h, 3);
  forEachRow(h, [&](int y) {
    float* out = rowOf(normals, y);
    for (int x = 0; x < w; ++x) {
      const double u = (x + 0.5) / w;
      const double v = (y + 0.5) / h;
      const Vertex at = surfaceVertex(point, u, v);
      const double texelU = glm::distance(point(u + 0.5 / w, v), point(u - 0.5 / w, v));
      const double texelV = glm::distance(point(u, v + 0.5 / h), point(u, v - 0.5 / h));
      const glm::dvec2 step = rise(height, x, y);
      // At a pole a texel has no width, and a slope along it means nothing.
      const double slopeU = texelU > 1e-6 ? step.x / texelU : 0.0;
      const double slopeV = texelV > 1e-6 ? step.y / texelV : 0.0;
      storeNormal(glm::normalize(at.normal - at.tangent * slopeU - at.bitangent * slopeV), out + 3 * x);
    }
  });
  return normals;
}

}  // namespace room
