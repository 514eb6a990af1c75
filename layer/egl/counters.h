// EGL_ANTEROOM_context_counters: eglQueryContext tells of a context that is current in the calling thread
// what it has done so far, modulo 2^31; of any other EGL_BAD_ACCESS. The numbers are of no registry, in none
// of its blocks.
#pragma once

#include <EGL/egl.h>

#define EGL_DRAWS_ANTEROOM 0x3FE0           // draws that reached the device
#define EGL_PIPELINES_ANTEROOM 0x3FE1       // made by its device, for all contexts
#define EGL_COMPILES_ANTEROOM 0x3FE2        // shaders compiled from text, the same
#define EGL_UPLOADED_BYTES_ANTEROOM 0x3FE3  // of textures

namespace anteroom::egl {

inline constexpr bool isCounter(EGLint attribute) {
  return attribute >= EGL_DRAWS_ANTEROOM && attribute <= EGL_UPLOADED_BYTES_ANTEROOM;
}

}  // namespace anteroom::egl
