// Framebuffer and renderbuffer objects (OES_framebuffer_object).
#pragma once

#include "layer/gl/context.h"
#include "layer/gl/shared_image.h"

namespace anteroom::gl {

struct Renderbuffer {
  explicit Renderbuffer(GLuint n) : name(n) {}

  const GLuint name;
  GLenum internalFormat = GL_RGBA4_OES;  // as specified
  int width = 0, height = 0;             // pixels
  std::shared_ptr<render::Image> image;  // null: no storage
  std::shared_ptr<SharedImage> shared;   // a sibling of an EGLImage, which is a part of `image`

  render::Attachment attachment() const {
    return {image, shared ? shared->level : 0, shared ? shared->layer : 0};
  }
};

// What is attached at one point: a level of a texture, a renderbuffer, or nothing.
struct AttachmentPoint {
  std::shared_ptr<Texture> texture;
  int face = 0;
  int level = 0;
  std::shared_ptr<Renderbuffer> renderbuffer;

  bool empty() const { return !texture && !renderbuffer; }
};

struct FramebufferObject {
  explicit FramebufferObject(GLuint n) : name(n) {}

  const GLuint name;
  AttachmentPoint color, depth, stencil;
};

// CheckFramebufferStatusOES. Under the ShareLock.
GLenum framebufferStatus(Context& c);

// Brings state.framebuffer up to date with the bound framebuffer object. Under the ShareLock. False: it is
// not complete, or memory ran out.
bool resolveFramebuffer(Context& c);

// A texture or renderbuffer is about to be deleted: it leaves the bound framebuffer object.
void detach(Context& c, const Texture* texture, const Renderbuffer* renderbuffer);

}  // namespace anteroom::gl
