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
  std::string label;
  GLenum usage = GL_STATIC_DRAW;
  std::shared_ptr<render::Buffer> store;  // null: size 0

  // OES_mapbuffer, EXT_map_buffer_range: what the program sees of the mapped range; it goes into the store
  // when it is unmapped or flushed. Null: not mapped.
  std::unique_ptr<std::byte[]> mapped;
  size_t mapOffset = 0, mapLength = 0;  // bytes
  GLbitfield mapAccess = 0;
};

class Context;

// Whether a draw would read a mapped buffer object: that is an error. Under the ShareLock.
bool readsMappedBuffer(const Context& c, bool indices);

}  // namespace anteroom::gl
