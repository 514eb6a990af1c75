#pragma once

#include "layer/gl/context/context.h"

namespace anteroom::gl {

// Where the hint for `target` is kept; null: no such hint (section 5.2).
GLenum* hintOf(Context& c, GLenum target);

}  // namespace anteroom::gl
