// PixelStorei and ReadPixels (sections 3.6.1, 4.3.1).
#include <algorithm>
#include <limits>

#include "layer/gl/context.h"
#include "layer/gl/framebuffer_object.h"
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

// ReadPixels, and ReadnPixelsEXT, which writes at most `room` bytes.
void readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, size_t room,
                void* pixels, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (!isPixelFormat(format))
    return c->setError(GL_INVALID_ENUM, wrongEnum("format", format, "Use RGBA"), command);
  if (!isPixelType(type))
    return c->setError(GL_INVALID_ENUM, wrongEnum("type", type, "Use UNSIGNED_BYTE"), command);
  if (width < 0 || height < 0)
    return c->setError(
        GL_INVALID_VALUE,
        wrongNumber(width < 0 ? "width" : "height", width < 0 ? width : height, "Give a size from 0 on"),
        command);
  ShareLock lock(*c->group);
  if (const GLenum error = readError(*c)) return c->setError(error, unreadable(), command);
  const render::Framebuffer& framebuffer = c->readFramebuffer;
  const PixelFormat own = implementationReadFormat(framebuffer);
  const bool rgba8 = format == GL_RGBA && type == GL_UNSIGNED_BYTE;
  if (!rgba8 && (format != own.format || type != own.type))
    return c->setError(
        GL_INVALID_OPERATION,
        wrongState("format and type are not those of this framebuffer",
                   "Use RGBA and UNSIGNED_BYTE, or what IMPLEMENTATION_COLOR_READ_FORMAT_OES and "
                   "_TYPE_OES say"),
        command);
  const render::Format packed = formatOf(format, type);
  const size_t pitch = rowPitch(width, packed, c->packAlignment), texel = render::info(packed).bytes;
  if (width > 0 && height > 0 &&
      pitch * static_cast<size_t>(height - 1) + texel * static_cast<size_t>(width) > room)
    return c->setError(GL_INVALID_OPERATION,
                       wrongNumber("bufSize", room, "Give room for every row, aligned by PACK_ALIGNMENT"),
                       command);

  const Span across(x, width, framebuffer.width), up(y, height, framebuffer.height);
  if (!pixels || !framebuffer.color.image || across.size == 0 || up.size == 0) return;
  std::byte* out = static_cast<std::byte*>(pixels) + static_cast<size_t>(int64_t{up.first} - y) * pitch +
                   static_cast<size_t>(int64_t{across.first} - x) * texel;
  const render::Rect rect{across.first, up.first, across.size, up.size};
  if (!c->renderer->readPixels(framebuffer, rect, packed, out, pitch))
    c->setError(GL_OUT_OF_MEMORY, {}, command);
}

}  // namespace

GL_API void GL_APIENTRY glPixelStorei(GLenum pname, GLint param) {
  Context* c = current();
  if (!c) return;
  if (pname != GL_PACK_ALIGNMENT && pname != GL_UNPACK_ALIGNMENT)
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, "Use PACK_ALIGNMENT or UNPACK_ALIGNMENT"));
  if (param != 1 && param != 2 && param != 4 && param != 8)
    return c->setError(GL_INVALID_VALUE, wrongNumber("param", param, "Use 1, 2, 4 or 8"));
  (pname == GL_PACK_ALIGNMENT ? c->packAlignment : c->unpackAlignment) = param;
}

GL_API void GL_APIENTRY glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                     GLenum type, void* pixels) {
  readPixels(x, y, width, height, format, type, std::numeric_limits<size_t>::max(), pixels);
}

GL_API void GL_APIENTRY glReadnPixelsEXT(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                         GLenum type, GLsizei bufSize, void* data) {
  readPixels(x, y, width, height, format, type, static_cast<size_t>(std::max(bufSize, 0)), data);
}
