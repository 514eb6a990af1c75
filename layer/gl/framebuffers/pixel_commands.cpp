// PixelStorei and ReadPixels (sections 3.6.1, 4.3.1), with the pairs of EXT_read_format_bgra and
// IMG_read_format.
#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "layer/gl/context/context.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/pixel.h"
#include "layer/render/pixels.h"

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

// Colors that a framebuffer's pixels can be read in (Table 3.3 without SRGB_EXT and SRGB_ALPHA_EXT).
bool isReadFormat(GLenum format) {
  return format == GL_BGRA_EXT || (format >= GL_ALPHA && format <= GL_LUMINANCE_ALPHA);
}

bool isReadType(GLenum type) {
  return isPixelType(type) || type == GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT ||
         type == GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT;
}

// Bytes of a pixel of BGRA_EXT. 0: there is no such pair.
size_t bgraBytes(GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE:
      return 4;
    case GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT:
    case GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT:
      return 2;
    default:
      return 0;
  }
}

// Blue in the lowest bits, alpha in the highest.
void packBgra(GLenum type, const uint8_t* rgba, int count, uint8_t* out) {
  const bool wide = type == GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT;
  const uint32_t most = wide ? 31 : 15;
  const int bits = wide ? 5 : 4;
  for (int i = 0; i < count; ++i, rgba += 4) {
    if (type == GL_UNSIGNED_BYTE) {
      const uint8_t pixel[4] = {rgba[2], rgba[1], rgba[0], rgba[3]};
      std::memcpy(out + size_t{4} * static_cast<size_t>(i), pixel, 4);
      continue;
    }
    const auto field = [&](int component) { return render::rescale(rgba[component], 255, most); };
    const uint32_t alpha = render::rescale(rgba[3], 255, wide ? 1 : 15);
    const auto packed =
        static_cast<uint16_t>(field(2) | field(1) << bits | field(0) << 2 * bits | alpha << 3 * bits);
    std::memcpy(out + size_t{2} * static_cast<size_t>(i), &packed, 2);
  }
}

// The rectangle lies inside the framebuffer. False: out of memory.
bool readBgra(Context& c, const render::Rect& rect, GLenum type, std::byte* out, size_t pitch) {
  const size_t rowBytes = size_t{4} * static_cast<size_t>(rect.width);
  const size_t rows = static_cast<size_t>(rect.height);
  const std::unique_ptr<std::byte[]> rgba(new (std::nothrow) std::byte[rowBytes * rows]);
  if (!rgba ||
      !c.renderer->readPixels(c.readFramebuffer, rect, render::Format::RGBA8, rgba.get(), rowBytes)) {
    return false;
  }
  for (size_t y = 0; y < rows; ++y) {
    packBgra(type, reinterpret_cast<const uint8_t*>(rgba.get() + y * rowBytes), rect.width,
             reinterpret_cast<uint8_t*>(out + y * pitch));
  }
  return true;
}

// ReadPixels, and ReadnPixelsEXT, which writes at most `room` bytes.
void readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, size_t room,
                void* pixels, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (!isReadFormat(format))
    return c->setError(GL_INVALID_ENUM, wrongEnum("format", format, "Use RGBA"), command);
  if (!isReadType(type))
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
  const size_t bgra = format == GL_BGRA_EXT ? bgraBytes(type) : 0;
  if (!rgba8 && bgra == 0 && (format != own.format || type != own.type))
    return c->setError(
        GL_INVALID_OPERATION,
        wrongState("format and type are not those of this framebuffer",
                   "Use RGBA and UNSIGNED_BYTE, or what IMPLEMENTATION_COLOR_READ_FORMAT_OES and "
                   "_TYPE_OES say"),
        command);
  const render::Format packed = formatOf(format, type);
  const size_t texel = bgra != 0 ? bgra : render::info(packed).bytes;
  const size_t pitch = rowPitch(width, texel, c->packAlignment);
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
  const bool read = bgra != 0 ? readBgra(*c, rect, type, out, pitch)
                              : c->renderer->readPixels(framebuffer, rect, packed, out, pitch);
  if (!read) c->setError(GL_OUT_OF_MEMORY, {}, command);
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
