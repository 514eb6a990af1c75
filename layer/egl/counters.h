// EGL_ANTEROOM_context_counters.
#pragma once

#include <EGL/egl.h>

#include "layer/egl/eglanteroom.h"

namespace anteroom::egl {

inline constexpr bool isCounter(EGLint attribute) {
  return attribute >= EGL_DRAWS_ANTEROOM && attribute <= EGL_UPLOADED_BYTES_ANTEROOM;
}

}  // namespace anteroom::egl
