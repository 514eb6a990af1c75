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

bool isPixelFormat(GLenum format);  // Table 3.3
bool isPixelType(GLenum type);      // Table 3.2

// None: not a pair of Table 3.4.
render::Format formatOf(GLenum format, GLenum type);
// The pair that a color format is: the inverse of formatOf.
PixelFormat pixelFormatOf(render::Format format);

// Bytes from one row to the next (equation 3.11).
constexpr size_t rowPitch(int width, render::Format format, int alignment) {
  const size_t bytes = static_cast<size_t>(width) * render::info(format).bytes;
  const size_t mask = static_cast<size_t>(alignment) - 1;
  return (bytes + mask) & ~mask;
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
// components as rows.format.
void convertRows(const PixelRows& rows, int width, int height, render::Format format, void* out,
                 size_t outPitch);

// What IMPLEMENTATION_COLOR_READ_FORMAT_OES and _TYPE_OES say of a framebuffer (section 4.3.1).
PixelFormat implementationReadFormat(const render::Framebuffer& framebuffer);

}  // namespace anteroom::gl
