#include "framebuffer.h"

#include <EGL/egl.h>
#include <fmt/format.h>

#include <stdexcept>

#include "context.h"

namespace room {
namespace {

template <typename Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (function == nullptr) throw std::runtime_error(fmt::format("eglGetProcAddress does not know {}", name));
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
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

  gl.genFramebuffers(1, &framebuffer_);
  gl.bindFramebuffer(GL_FRAMEBUFFER_OES, framebuffer_);
  gl.framebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture_, 0);
  if (depth == Depth::Bits16) {
    gl.genRenderbuffers(1, &depth_);
    gl.bindRenderbuffer(GL_RENDERBUFFER_OES, depth_);
    gl.renderbufferStorage(GL_RENDERBUFFER_OES, GL_DEPTH_COMPONENT16_OES, size, size);
    gl.framebufferRenderbuffer(GL_FRAMEBUFFER_OES, GL_DEPTH_ATTACHMENT_OES, GL_RENDERBUFFER_OES, depth_);
    gl.bindRenderbuffer(GL_RENDERBUFFER_OES, 0);
  }
  const GLenum status = gl.checkFramebufferStatus(GL_FRAMEBUFFER_OES);
  unbind();
  if (status != GL_FRAMEBUFFER_COMPLETE_OES) {
    destroy();
    throw std::runtime_error(
        fmt::format("a framebuffer object of {0} x {0} pixels is not complete: 0x{1:04X}", size, status));
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

}  // namespace room
