// The commands of EGL 1.5, and the table of them by which libEGL reaches the implementation.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdint>

// X(result, name, parameters, arguments), in the order of the alphabet.
// clang-format off
#define ANTEROOM_EGL_COMMANDS(X) \
  X(EGLBoolean, eglBindAPI, (EGLenum api), (api)) \
  X(EGLBoolean, eglBindTexImage, (EGLDisplay dpy, EGLSurface surface, EGLint buffer), (dpy, surface, buffer)) \
  X(EGLBoolean, eglChooseConfig, (EGLDisplay dpy, const EGLint* attrib_list, EGLConfig* configs, EGLint config_size, EGLint* num_config), (dpy, attrib_list, configs, config_size, num_config)) \
  X(EGLint, eglClientWaitSync, (EGLDisplay dpy, EGLSync sync, EGLint flags, EGLTime timeout), (dpy, sync, flags, timeout)) \
  X(EGLBoolean, eglCopyBuffers, (EGLDisplay dpy, EGLSurface surface, EGLNativePixmapType target), (dpy, surface, target)) \
  X(EGLContext, eglCreateContext, (EGLDisplay dpy, EGLConfig config, EGLContext share_context, const EGLint* attrib_list), (dpy, config, share_context, attrib_list)) \
  X(EGLImage, eglCreateImage, (EGLDisplay dpy, EGLContext ctx, EGLenum target, EGLClientBuffer buffer, const EGLAttrib* attrib_list), (dpy, ctx, target, buffer, attrib_list)) \
  X(EGLSurface, eglCreatePbufferFromClientBuffer, (EGLDisplay dpy, EGLenum buftype, EGLClientBuffer buffer, EGLConfig config, const EGLint* attrib_list), (dpy, buftype, buffer, config, attrib_list)) \
  X(EGLSurface, eglCreatePbufferSurface, (EGLDisplay dpy, EGLConfig config, const EGLint* attrib_list), (dpy, config, attrib_list)) \
  X(EGLSurface, eglCreatePixmapSurface, (EGLDisplay dpy, EGLConfig config, EGLNativePixmapType pixmap, const EGLint* attrib_list), (dpy, config, pixmap, attrib_list)) \
  X(EGLSurface, eglCreatePlatformPixmapSurface, (EGLDisplay dpy, EGLConfig config, void* native_pixmap, const EGLAttrib* attrib_list), (dpy, config, native_pixmap, attrib_list)) \
  X(EGLSurface, eglCreatePlatformWindowSurface, (EGLDisplay dpy, EGLConfig config, void* native_window, const EGLAttrib* attrib_list), (dpy, config, native_window, attrib_list)) \
  X(EGLSync, eglCreateSync, (EGLDisplay dpy, EGLenum type, const EGLAttrib* attrib_list), (dpy, type, attrib_list)) \
  X(EGLSurface, eglCreateWindowSurface, (EGLDisplay dpy, EGLConfig config, EGLNativeWindowType win, const EGLint* attrib_list), (dpy, config, win, attrib_list)) \
  X(EGLBoolean, eglDestroyContext, (EGLDisplay dpy, EGLContext ctx), (dpy, ctx)) \
  X(EGLBoolean, eglDestroyImage, (EGLDisplay dpy, EGLImage image), (dpy, image)) \
  X(EGLBoolean, eglDestroySurface, (EGLDisplay dpy, EGLSurface surface), (dpy, surface)) \
  X(EGLBoolean, eglDestroySync, (EGLDisplay dpy, EGLSync sync), (dpy, sync)) \
  X(EGLBoolean, eglGetConfigAttrib, (EGLDisplay dpy, EGLConfig config, EGLint attribute, EGLint* value), (dpy, config, attribute, value)) \
  X(EGLBoolean, eglGetConfigs, (EGLDisplay dpy, EGLConfig* configs, EGLint config_size, EGLint* num_config), (dpy, configs, config_size, num_config)) \
  X(EGLContext, eglGetCurrentContext, (), ()) \
  X(EGLDisplay, eglGetCurrentDisplay, (), ()) \
  X(EGLSurface, eglGetCurrentSurface, (EGLint readdraw), (readdraw)) \
  X(EGLDisplay, eglGetDisplay, (EGLNativeDisplayType display_id), (display_id)) \
  X(EGLint, eglGetError, (), ()) \
  X(EGLDisplay, eglGetPlatformDisplay, (EGLenum platform, void* native_display, const EGLAttrib* attrib_list), (platform, native_display, attrib_list)) \
  X(__eglMustCastToProperFunctionPointerType, eglGetProcAddress, (const char* procname), (procname)) \
  X(EGLBoolean, eglGetSyncAttrib, (EGLDisplay dpy, EGLSync sync, EGLint attribute, EGLAttrib* value), (dpy, sync, attribute, value)) \
  X(EGLBoolean, eglInitialize, (EGLDisplay dpy, EGLint* major, EGLint* minor), (dpy, major, minor)) \
  X(EGLBoolean, eglMakeCurrent, (EGLDisplay dpy, EGLSurface draw, EGLSurface read, EGLContext ctx), (dpy, draw, read, ctx)) \
  X(EGLenum, eglQueryAPI, (), ()) \
  X(EGLBoolean, eglQueryContext, (EGLDisplay dpy, EGLContext ctx, EGLint attribute, EGLint* value), (dpy, ctx, attribute, value)) \
  X(const char*, eglQueryString, (EGLDisplay dpy, EGLint name), (dpy, name)) \
  X(EGLBoolean, eglQuerySurface, (EGLDisplay dpy, EGLSurface surface, EGLint attribute, EGLint* value), (dpy, surface, attribute, value)) \
  X(EGLBoolean, eglReleaseTexImage, (EGLDisplay dpy, EGLSurface surface, EGLint buffer), (dpy, surface, buffer)) \
  X(EGLBoolean, eglReleaseThread, (), ()) \
  X(EGLBoolean, eglSurfaceAttrib, (EGLDisplay dpy, EGLSurface surface, EGLint attribute, EGLint value), (dpy, surface, attribute, value)) \
  X(EGLBoolean, eglSwapBuffers, (EGLDisplay dpy, EGLSurface surface), (dpy, surface)) \
  X(EGLBoolean, eglSwapInterval, (EGLDisplay dpy, EGLint interval), (dpy, interval)) \
  X(EGLBoolean, eglTerminate, (EGLDisplay dpy), (dpy)) \
  X(EGLBoolean, eglWaitClient, (), ()) \
  X(EGLBoolean, eglWaitGL, (), ()) \
  X(EGLBoolean, eglWaitNative, (EGLint engine), (engine)) \
  X(EGLBoolean, eglWaitSync, (EGLDisplay dpy, EGLSync sync, EGLint flags), (dpy, sync, flags))

// Commands of extensions: found by eglGetProcAddress alone.
#define ANTEROOM_EGL_EXTENSION_COMMANDS(X) \
  X(eglClientWaitSyncKHR)                  \
  X(eglCreateImageKHR)                     \
  X(eglCreatePlatformPixmapSurfaceEXT)     \
  X(eglCreatePlatformWindowSurfaceEXT)     \
  X(eglCreateSyncKHR)                      \
  X(eglDebugMessageControlKHR)             \
  X(eglDestroyImageKHR)                    \
  X(eglDestroySyncKHR)                     \
  X(eglGetPlatformDisplayEXT)              \
  X(eglGetSyncAttribKHR)                   \
  X(eglLabelObjectKHR)                     \
  X(eglQueryDebugKHR)                      \
  X(eglQueryDeviceAttribEXT)               \
  X(eglQueryDeviceStringEXT)               \
  X(eglQueryDevicesEXT)                    \
  X(eglQueryDisplayAttribEXT)              \
  X(eglSignalSyncKHR)                      \
  X(eglSwapBuffersWithDamageEXT)           \
  X(eglSwapBuffersWithDamageKHR)           \
  X(eglWaitSyncKHR)
// clang-format on

namespace anteroom::egl {

// Counts changes of CommandTable's layout.
inline constexpr uint32_t kTableVersion = 1;

// `version` and `size` stay the first members in every version, so that two files that do not belong together
// notice.
struct CommandTable {
  uint32_t version;
  uint32_t size;
#define ANTEROOM_MEMBER(Result, name, parameters, arguments) decltype(&::name) name;
  ANTEROOM_EGL_COMMANDS(ANTEROOM_MEMBER)
#undef ANTEROOM_MEMBER
};

}  // namespace anteroom::egl
