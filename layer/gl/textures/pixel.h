// Pixel rectangles in client memory (section 3.6): which format and type pairs there are, how rows lie, and
// conversion between the formats that store one base format.
#pragma once

#include <GLES/gl.h>

#include <cstddef>

#include "layer/render/format.h"
#include "layer/render/state.h"

namespace anteroom::gl {

// A format and type pair of Table 3.4.
struct PixelFormat {
  GLenum format = 0;
  GLenum type = 0;
};

bool isPixelFormat(GLenum format);  // Table 3.3, with BGRA_EXT, SRGB_EXT and SRGB_ALPHA_EXT
bool isPixelType(GLenum type);      // Table 3.2

// How texels of the pair lie in client memory. None: not a pair of Table 3.4.
render::Format formatOf(GLenum format, GLenum type);
// The pair that a color format is: the inverse of formatOf.
PixelFormat pixelFormatOf(render::Format format);
// What texels of a format in client memory are stored in.
constexpr render::Format storedFormat(render::Format format) {
  return format == render::Format::BGRA8 ? render::Format::RGBA8 : format;
}

// Bytes from one row of texels, of `bytes` each, to the next (equation 3.11).
constexpr size_t rowPitch(int width, size_t bytes, int alignment) {
  const size_t mask = static_cast<size_t>(alignment) - 1;
  return (static_cast<size_t>(width) * bytes + mask) & ~mask;
}
constexpr size_t rowPitch(int width, render::Format format, int alignment) {
  return rowPitch(width, size_t{render::info(format).bytes}, alignment);
}

// The format of the same components that loses nothing of `format`, nor of any other with its components.
constexpr render::Format widest(render::Format format) {
  switch (format) {
    case render::Format::RGB565:
      return render::Format::RGB8;
    case render::Format::RGBA4444:
    case render::Format::RGBA5551:
      return render::Format::RGBA8;
    default:
      return format;
  }
}

// Rows of texels in client memory, lowest first; no alignment is assumed.
struct PixelRows {
  const void* data = nullptr;
  size_t pitch = 0;  // bytes
  render::Format format = render::Format::None;
};

// Copies width x height texels, each component rounded to the nearest value of `format`, which has the same
// components as rows.format. sRGB colors stay encoded.
void convertRows(const PixelRows& rows, int width, int height, render::Format format, void* out,
                 size_t outPitch);

// What IMPLEMENTATION_COLOR_READ_FORMAT_OES and _TYPE_OES say of a framebuffer (section 4.3.1).
PixelFormat implementationReadFormat(const render::Framebuffer& framebuffer);

}  // namespace anteroom::gl
