#include "texture.h"

#include <GLES/glext.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace room {
namespace {

void uploadLevel(GLenum face, int level, const Image& image, GLenum format) {
  const OIIO::ImageSpec& spec = image.spec();
  const auto* from = static_cast<const float*>(image.localpixels());
  std::vector<std::uint8_t> bytes(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  std::transform(from, from + bytes.size(), bytes.begin(), [](float x) {
    return static_cast<std::uint8_t>(std::clamp(x, 0.0F, 1.0F) * 255.0F + 0.5F);
  });
  glTexImage2D(face, level, static_cast<GLint>(format), spec.width, spec.height, 0, format, GL_UNSIGNED_BYTE,
               bytes.data());
}

void uploadLevels(GLenum face, const Image& image, GLenum format, bool mipmaps) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  uploadLevel(face, 0, image, format);
  if (!mipmaps) return;
  Image level = image;
  for (int i = 1; level.spec().width > 1 || level.spec().height > 1; ++i) {
    // Normals get shorter where they differ, which is just what averaged diffuse light needs.
    level = halved(level);
    uploadLevel(face, i, level, format);
  }
}

GLenum formatOf(const Image& image, GLenum singleChannel) {
  switch (image.spec().nchannels) {
    case 1:
      return singleChannel;
    case 2:
      return GL_LUMINANCE_ALPHA;
    case 3:
      return GL_RGB;
    default:
      return GL_RGBA;
  }
}

void setSampling(GLenum target, Filter filter, GLenum wrap) {
  const GLint magnify = filter == Filter::Nearest ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER,
                  filter == Filter::Mipmapped ? GL_LINEAR_MIPMAP_LINEAR : magnify);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
  glTexParameteri(target, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
}

}  // namespace

Texture::Texture(GLenum target) : target_(target) {
  glGenTextures(1, &name_);
}

Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

Texture::Texture(Texture&& other) noexcept : target_(other.target_), name_(std::exchange(other.name_, 0)) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(target_, other.target_);
  std::swap(name_, other.name_);
  return *this;
}

Texture makeTexture(const Image& image, Filter filter, GLenum wrap, GLenum singleChannel) {
  Texture texture(GL_TEXTURE_2D);
  texture.bind();
  setSampling(GL_TEXTURE_2D, filter, wrap);
  uploadLevels(GL_TEXTURE_2D, image, formatOf(image, singleChannel), filter == Filter::Mipmapped);
  return texture;
}

Texture materialTexture(int size, const TexelFunction& texel, GLenum wrap) {
  return makeTexture(bake(size, size, texel).color, Filter::Mipmapped, wrap);
}

Texture makeCubeTexture(const std::array<Image, 6>& faces, Filter filter) {
  Texture texture(GL_TEXTURE_CUBE_MAP_OES);
  texture.bind();
  setSampling(GL_TEXTURE_CUBE_MAP_OES, filter, GL_CLAMP_TO_EDGE);
  for (std::size_t face = 0; face < faces.size(); ++face) {
    uploadLevels(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + static_cast<GLenum>(face), faces[face],
                 formatOf(faces[face], GL_LUMINANCE), filter == Filter::Mipmapped);
  }
  return texture;
}

glm::dvec3 cubeDirection(int face, double s, double t) {
  const double a = 2 * s - 1;
  const double b = 2 * t - 1;
  switch (face) {
    case 0:
      return glm::normalize(glm::dvec3(1, -b, -a));
    case 1:
      return glm::normalize(glm::dvec3(-1, -b, a));
    case 2:
      return glm::normalize(glm::dvec3(a, 1, b));
    case 3:
      return glm::normalize(glm::dvec3(a, -1, -b));
    case 4:
      return glm::normalize(glm::dvec3(a, -b, 1));
    default:
      return glm::normalize(glm::dvec3(-a, -b, -1));
  }
}

}  // namespace room
