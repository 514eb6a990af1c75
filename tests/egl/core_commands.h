// The commands of EGL 1.5 and of OpenGL ES 1.1, as the Khronos registry lists them.
#pragma once

namespace egl_conformance {

inline constexpr const char* kEglCommands[] = {"eglBindAPI",
                                               "eglBindTexImage",
                                               "eglChooseConfig",
                                               "eglClientWaitSync",
                                               "eglCopyBuffers",
                                               "eglCreateContext",
                                               "eglCreateImage",
                                               "eglCreatePbufferFromClientBuffer",
                                               "eglCreatePbufferSurface",
                                               "eglCreatePixmapSurface",
                                               "eglCreatePlatformPixmapSurface",
                                               "eglCreatePlatformWindowSurface",
                                               "eglCreateSync",
                                               "eglCreateWindowSurface",
                                               "eglDestroyContext",
                                               "eglDestroyImage",
                                               "eglDestroySurface",
                                               "eglDestroySync",
                                               "eglGetConfigAttrib",
                                               "eglGetConfigs",
                                               "eglGetCurrentContext",
                                               "eglGetCurrentDisplay",
                                               "eglGetCurrentSurface",
                                               "eglGetDisplay",
                                               "eglGetError",
                                               "eglGetPlatformDisplay",
                                               "eglGetProcAddress",
                                               "eglGetSyncAttrib",
                                               "eglInitialize",
                                               "eglMakeCurrent",
                                               "eglQueryAPI",
                                               "eglQueryContext",
                                               "eglQueryString",
                                               "eglQuerySurface",
                                               "eglReleaseTexImage",
                                               "eglReleaseThread",
                                               "eglSurfaceAttrib",
                                               "eglSwapBuffers",
                                               "eglSwapInterval",
                                               "eglTerminate",
                                               "eglWaitClient",
                                               "eglWaitGL",
                                               "eglWaitNative",
                                               "eglWaitSync"};

inline constexpr const char* kGlCommands[] = {
#define ANTEROOM_COMMAND(name) #name,
#include "registry/core_commands.inc"
#undef ANTEROOM_COMMAND
};

}  // namespace egl_conformance
