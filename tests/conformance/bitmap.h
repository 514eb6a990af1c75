// Images on the CPU for the texturing cases.
#pragma once

#include "harness.h"

namespace conformance {

// An RGBA image on the CPU.
struct Bitmap {
  int width, height;
  std::vector<GLubyte> bytes;

  Bitmap(int w, int h) : width(w), height(h), bytes(static_cast<std::size_t>(w) * h * 4) {}
  GLubyte* at(int x, int y) { return bytes.data() + (static_cast<std::size_t>(y) * width + x) * 4; }
  Vec4 color(int x, int y) const {
    const GLubyte* t = bytes.data() + (static_cast<std::size_t>(y) * width + x) * 4;
    return {t[0] / 255.0, t[1] / 255.0, t[2] / 255.0, t[3] / 255.0};
  }
  void upload(GLint level = 0, GLenum target = GL_TEXTURE_2D) const {
    glTexImage2D(target, level, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  }
};

inline Bitmap noise(int width, int height) {
  Bitmap bitmap(width, height);
  unsigned state = 12345;
  for (GLubyte& byte : bitmap.bytes)
    byte = static_cast<GLubyte>((state = state * 1664525u + 1013904223u) >> 24);
  return bitmap;
}

inline Bitmap solid(int width, int height, const std::array<GLubyte, 4>& color) {
  Bitmap bitmap(width, height);
  for (std::size_t i = 0; i < bitmap.bytes.size(); ++i) bitmap.bytes[i] = color[i % 4];
  return bitmap;
}

inline GLuint bindNew() {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  useNearest();
  return name;
}

}  // namespace conformance
