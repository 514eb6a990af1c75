// Pictures that are drawn and then read as textures (GL_OES_framebuffer_object).
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <glm/glm.hpp>
#include <string_view>

namespace room {

// The entry points of the extension, from eglGetProcAddress.
struct FramebufferFunctions {
  // Throws MissingExtension where the current context has no framebuffer objects; `demo` is named in it.
  explicit FramebufferFunctions(std::string_view demo);

  PFNGLGENFRAMEBUFFERSOESPROC genFramebuffers;
  PFNGLDELETEFRAMEBUFFERSOESPROC deleteFramebuffers;
  PFNGLBINDFRAMEBUFFEROESPROC bindFramebuffer;
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC framebufferTexture2D;
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC framebufferRenderbuffer;
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC checkFramebufferStatus;
  PFNGLGENRENDERBUFFERSOESPROC genRenderbuffers;
  PFNGLDELETERENDERBUFFERSOESPROC deleteRenderbuffers;
  PFNGLBINDRENDERBUFFEROESPROC bindRenderbuffer;
  PFNGLRENDERBUFFERSTORAGEOESPROC renderbufferStorage;
};

// A square RGBA texture with linear filtering, clamped at its edges, in a framebuffer object of its own.
class RenderTarget {
 public:
  enum class Depth { None, Bits16 };

  // The functions outlive the target. Throws std::runtime_error where the framebuffer is not complete.
  RenderTarget(const FramebufferFunctions& gl, int size, Depth depth = Depth::None);
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  int size() const { return size_; }
  // From here on everything is drawn into the target; the viewport is all of it.
  void bind() const;
  // From here on everything is drawn into the surface of the context again. The viewport is left alone.
  void unbind() const;
  void bindTexture() const { glBindTexture(GL_TEXTURE_2D, texture_); }

 private:
  void destroy();

  const FramebufferFunctions* gl_;
  int size_;
  GLuint texture_ = 0;
  GLuint depth_ = 0;
  GLuint framebuffer_ = 0;
};

// A cube map with a framebuffer object for each face; all share one depth buffer of 16 bits.
class CubeTarget {
 public:
  // As for RenderTarget; needs GL_OES_texture_cube_map besides.
  CubeTarget(const FramebufferFunctions& gl, int size);
  ~CubeTarget();
  CubeTarget(const CubeTarget&) = delete;
  CubeTarget& operator=(const CubeTarget&) = delete;

  int size() const { return size_; }
  // From here on everything is drawn into a face, 0 to 5 for +X -X +Y -Y +Z -Z; the viewport is all of it.
  void bind(int face) const;
  void unbind() const;
  void bindTexture() const { glBindTexture(GL_TEXTURE_CUBE_MAP_OES, texture_); }

 private:
  void destroy();

  const FramebufferFunctions* gl_;
  int size_;
  GLuint texture_ = 0;
  GLuint depth_ = 0;
  std::array<GLuint, 6> framebuffers_{};
};

// What a camera at a point sees through a face of a cube map: 90 degrees, aspect 1.
glm::dmat4 cubeFaceCamera(int face, const glm::dvec3& eye);
glm::dmat4 cubeFaceProjection(double near, double far);

}  // namespace room
