#include "framebuffer.h"

#include <EGL/egl.h>
#include <fmt/format.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "context.h"
#include "texture.h"

namespace room {
namespace {

template <typename Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (function == nullptr) throw std::runtime_error(fmt::format("eglGetProcAddress does not know {}", name));
}

GLuint makeDepth(const FramebufferFunctions& gl, int size) {
  GLuint depth = 0;
  gl.genRenderbuffers(1, &depth);
  gl.bindRenderbuffer(GL_RENDERBUFFER_OES, depth);
  gl.renderbufferStorage(GL_RENDERBUFFER_OES, GL_DEPTH_COMPONENT16_OES, size, size);
  gl.bindRenderbuffer(GL_RENDERBUFFER_OES, 0);
  return depth;
}

void setLinear(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

std::runtime_error incomplete(int size, GLenum status) {
  return std::runtime_error(
      fmt::format("a framebuffer object of {0} x {0} pixels is not complete: 0x{1:04X}", size, status));
}

}  // namespace

FramebufferFunctions::FramebufferFunctions(std::string_view demo) {
  requireExtension("GL_OES_framebuffer_object", demo);
  load(genFramebuffers, "glGenFramebuffersOES");
  load(deleteFramebuffers, "glDeleteFramebuffersOES");
  load(bindFramebuffer, "glBindFramebufferOES");
  load(framebufferTexture2D, "glFramebufferTexture2DOES");
  load(framebufferRenderbuffer, "glFramebufferRenderbufferOES");
  load(checkFramebufferStatus, "glCheckFramebufferStatusOES");
  load(genRenderbuffers, "glGenRenderbuffersOES");
  load(deleteRenderbuffers, "glDeleteRenderbuffersOES");
  load(bindRenderbuffer, "glBindRenderbufferOES");
  load(renderbufferStorage, "glRenderbufferStorageOES");
}

RenderTarget::RenderTarget(const FramebufferFunctions& gl, int size, Depth depth) : gl_(&gl), size_(size) {
  glGenTextures(1, &texture_);
  bindTexture();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  setLinear(GL_TEXTURE_2D);

  gl.genFramebuffers(1, &framebuffer_);
  gl.bindFramebuffer(GL_FRAMEBUFFER_OES, framebuffer_);
  gl.framebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture_, 0);
  if (depth == Depth::Bits16) {
    depth_ = makeDepth(gl, size);
    gl.framebufferRenderbuffer(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES, depth_);
  }
  const GLenum status = gl.checkFramebufferStatus(GL_FRAMEBUFFER_OES);
  unbind();
  if (status != GL_FRAMEBUFFER_COMPLETE_OES) {
    destroy();
    throw incomplete(size, status);
  }
}

RenderTarget::~RenderTarget() {
  destroy();
}

void RenderTarget::destroy() {
  gl_->deleteFramebuffers(1, &framebuffer_);
  if (depth_ != 0) gl_->deleteRenderbuffers(1, &depth_);
  glDeleteTextures(1, &texture_);
}

void RenderTarget::bind() const {
  gl_->bindFramebuffer(GL_FRAMEBUFFER_OES, framebuffer_);
  glViewport(0, 0, size_, size_);
}

void RenderTarget::unbind() const {
  gl_->bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

CubeTarget::CubeTarget(const FramebufferFunctions& gl, int size) : gl_(&gl), size_(size) {
  glGenTextures(1, &texture_);
  bindTexture();
  setLinear(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, size, size, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
  }
  depth_ = makeDepth(gl, size);
  gl.genFramebuffers(6, framebuffers_.data());
  for (GLenum face = 0; face < 6; ++face) {
    gl.bindFramebuffer(GL_FRAMEBUFFER_OES, framebuffers_[face]);
    gl.framebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES,
                            GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, texture_, 0);
    gl.framebufferRenderbuffer(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES, depth_);
    const GLenum status = gl.checkFramebufferStatus(GL_FRAMEBUFFER_OES);
    if (status == GL_FRAMEBUFFER_COMPLETE_OES) continue;
    destroy();
    throw incomplete(size, status);
  }
  unbind();
}

CubeTarget::~CubeTarget() {
  destroy();
}

void CubeTarget::destroy() {
  gl_->deleteFramebuffers(6, framebuffers_.data());
  gl_->deleteRenderbuffers(1, &depth_);
  glDeleteTextures(1, &texture_);
}

void CubeTarget::bind(int face) const {
  gl_->bindFramebuffer(GL_FRAMEBUFFER_OES, framebuffers_[static_cast<std::size_t>(face)]);
  glViewport(0, 0, size_, size_);
}

void CubeTarget::unbind() const {
  gl_->bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

glm::dmat4 cubeFaceCamera(int face, const glm::dvec3& eye) {
  // Up is where t grows.
  const glm::dvec3 forward = cubeDirection(face, 0.5, 0.5);
  const glm::dvec3 up = cubeDirection(face, 0.5, 1.0) - cubeDirection(face, 0.5, 0.0);
  return glm::lookAt(eye, eye + forward, up);
}

glm::dmat4 cubeFaceProjection(double near, double far) {
  return glm::perspective(glm::half_pi<double>(), 1.0, near, far);
}

}  // namespace room
