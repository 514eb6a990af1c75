// GL textures made from images, with every mip level uploaded by us: no two implementations filter alike.
#pragma once

#include <GLES/gl.h>

#include <array>

#include "image.h"

namespace room {

class Texture {
 public:
  Texture() = default;
  explicit Texture(GLenum target);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  void bind() const { glBindTexture(target_, name_); }

 private:
  GLenum target_ = GL_TEXTURE_2D;
  GLuint name_ = 0;
};

enum class Filter { Nearest, Linear, Mipmapped };

// 1 channel becomes `singleChannel` (GL_ALPHA or GL_LUMINANCE), 2 become GL_LUMINANCE_ALPHA, 3 GL_RGB and
// 4 GL_RGBA.
// Sizes are powers of two. wrap: GL_REPEAT or GL_CLAMP_TO_EDGE.
Texture makeTexture(const Image& image, Filter filter, GLenum wrap, GLenum singleChannel = GL_LUMINANCE);

// The color of a procedural material, size x size texels with mip levels.
Texture materialTexture(int size, const TexelFunction& texel, GLenum wrap = GL_REPEAT);

// Six faces in the order +X -X +Y -Y +Z -Z (GL_OES_texture_cube_map).
Texture makeCubeTexture(const std::array<Image, 6>& faces, Filter filter);

// The direction that texel (s, t) in [0,1]^2 of a face looks at, table 3.21 of the extension.
glm::dvec3 cubeDirection(int face, double s, double t);

}  // namespace room
