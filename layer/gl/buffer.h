// Buffer objects (section 2.9).
#pragma once

#include <GLES/gl.h>

#include <cstddef>
#include <memory>

#include "layer/render/renderer.h"

namespace anteroom::gl {

struct BufferObject {
  explicit BufferObject(GLuint n) : name(n) {}

  size_t size() const { return store ? store->size() : 0; }

  const GLuint name;
  GLenum usage = GL_STATIC_DRAW;
  std::shared_ptr<render::Buffer> store;  // null: size 0
};

}  // namespace anteroom::gl
