// What Enable, Disable and EnableClientState switch, for queries.
#pragma once

#include "layer/gl/context/context.h"

namespace anteroom::gl {

// Capabilities and client arrays. False: there is neither of that name.
bool isEnabled(Context& c, GLenum name, bool& enabled);

}  // namespace anteroom::gl
