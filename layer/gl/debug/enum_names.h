// The names of enumerants, for messages.
#pragma once

#include <GLES/gl.h>

#include <string_view>

namespace anteroom::gl {

// As headers have it, such as "GL_TEXTURE_2D": ours where we have one, otherwise that of any other GL. Empty:
// there is none. Numbers below 0x100 have too many.
std::string_view enumName(GLenum value);

}  // namespace anteroom::gl
