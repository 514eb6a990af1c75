// Floating-point images made by code. Row 0 is v = 0, the first row that GL takes.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <functional>
#include <glm/glm.hpp>

#include "mesh.h"

namespace room {

using Image = OIIO::ImageBuf;

// What a procedural material is at one point of its texture.
struct Texel {
  glm::dvec3 color{0.5};  // [0,1], as it is displayed
  double height = 0;      // metres
  double gloss = 0;       // [0,1]
};
using TexelFunction = std::function<Texel(double u, double v)>;

struct BakedTexels {
  Image color;   // 3 channels
  Image height;  // 1 channel, metres
  Image gloss;   // 1 channel
};

// Evaluates the function at every texel centre of a width x height image, rows in parallel.
BakedTexels bake(int width, int height, const TexelFunction& texel);

// Any image by a function of the texel centre (u, v) that fills its channels.
Image generate(int width, int height, int channels,
               const std::function<void(double u, double v, float* out)>& f);

// Unit normals in tangent space, scaled and biased to [0,1]; one repeat of the texture covers `extent`
// metres.
Image tangentNormals(const Image& height, glm::dvec2 extent);

// The same in the object's own space for a texture that is wrapped around a surface once.
Image objectNormals(const Image& height, const SurfaceFunction& point);

// Half the size in each direction, the mean of 2x2: the next mip level.
Image halved(const Image& image);

}  // namespace room
