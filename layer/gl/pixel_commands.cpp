// PixelStorei and ReadPixels (sections 3.6.1, 4.3.1).
#include <algorithm>

#include "layer/gl/context.h"
#include "layer/gl/pixel.h"

using namespace anteroom::gl;
namespace render = anteroom::render;

namespace {

// The part of [start, start + count) that lies in [0, limit).
struct Span {
  Span(int start, int count, int limit) {
    const int64_t end = std::min<int64_t>(int64_t{start} + count, limit);
    first = std::max(start, 0);
    size = static_cast<int>(std::max<int64_t>(end - first, 0));
  }
  int first, size;
};

}  // namespace

GL_API void GL_APIENTRY glPixelStorei(GLenum pname, GLint param) {
  Context* c = current();
  if (!c) return;
  if (pname != GL_PACK_ALIGNMENT && pname != GL_UNPACK_ALIGNMENT) return c->setError(GL_INVALID_ENUM);
  if (param != 1 && param != 2 && param != 4 && param != 8) return c->setError(GL_INVALID_VALUE);
  (pname == GL_PACK_ALIGNMENT ? c->packAlignment : c->unpackAlignment) = param;
}

GL_API void GL_APIENTRY glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                     GLenum type, void* pixels) {
  Context* c = current();
  if (!c) return;
  if (!isPixelFormat(format) || !isPixelType(type)) return c->setError(GL_INVALID_ENUM);
  if (width < 0 || height < 0) return c->setError(GL_INVALID_VALUE);
  ShareLock lock(*c->group);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES);
  const render::Framebuffer& framebuffer = c->readFramebuffer;
  const PixelFormat own = implementationReadFormat(framebuffer);
  const bool rgba8 = format == GL_RGBA && type == GL_UNSIGNED_BYTE;
  if (!rgba8 && (format != own.format || type != own.type)) return c->setError(GL_INVALID_OPERATION);

  const Span across(x, width, framebuffer.width), up(y, height, framebuffer.height);
  if (!pixels || !framebuffer.color.image || across.size == 0 || up.size == 0) return;
  const render::Format packed = formatOf(format, type);
  const size_t pitch = rowPitch(width, packed, c->packAlignment);
  std::byte* out = static_cast<std::byte*>(pixels) + static_cast<size_t>(int64_t{up.first} - y) * pitch +
                   static_cast<size_t>(int64_t{across.first} - x) * render::info(packed).bytes;
  const render::Rect rect{across.first, up.first, across.size, up.size};
  if (!c->renderer->readPixels(framebuffer, rect, packed, out, pitch)) c->setError(GL_OUT_OF_MEMORY);
}
