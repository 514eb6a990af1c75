// What internal formats of textures are: base formats (Table 3.8), sized ones (OES_required_internalformat,
// EXT_texture_storage), compressed and paletted ones.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include "layer/render/format.h"

namespace anteroom::gl {

// ALPHA, LUMINANCE, LUMINANCE_ALPHA, RGB or RGBA: what a texture function sees. 0: not an internal format.
GLenum baseFormatOf(GLenum internalFormat);

bool isSized(GLenum internalFormat);
bool isSrgb(GLenum internalFormat);
// Paletted formats included.
bool isCompressed(GLenum internalFormat);

// Whether TexImage2D knows it: one of `internalformat` in Table 3.4, with any format and type.
bool isTexImageFormat(GLenum internalFormat);
// Table 3.4: a format and type pair with an internal format.
bool combines(GLenum internalFormat, GLenum format, GLenum type);
// Whether texels of `format` may replace some of `internalFormat` (TexSubImage2D).
bool takesTexels(GLenum internalFormat, GLenum format);

// Table 3.4.y of OES_required_internalformat: CopyTexImage2D.
bool isCopyFormat(GLenum internalFormat);

// What TexStorage2DEXT stores it in. None: it takes no such internal format.
render::Format storageFormat(GLenum internalFormat);
// What a sized format stores at least. None: not a sized format.
render::Format sizedFormat(GLenum internalFormat);

}  // namespace anteroom::gl
