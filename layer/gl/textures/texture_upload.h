// Texels on their way into an image, whatever format they come in. False: out of memory.
#pragma once

#include "layer/gl/context/context.h"
#include "layer/gl/textures/pixel.h"

namespace anteroom::gl {

// `rows` has the components of the image's format.
bool upload(Context& c, render::Image& image, const render::Region& region, const PixelRows& rows);

// Zeros.
bool clear(Context& c, render::Image& image, const render::Region& region);

// Whether every pixel of `rect` is inside.
bool covers(const render::Framebuffer& framebuffer, const render::Rect& rect);

}  // namespace anteroom::gl
