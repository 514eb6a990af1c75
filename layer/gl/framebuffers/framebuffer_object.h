// Framebuffer and renderbuffer objects (OES_framebuffer_object).
#pragma once

#include "layer/gl/context/context.h"
#include "layer/gl/textures/shared_image.h"

namespace anteroom::gl {

// Which extension made it multisampled. Pixels of Apple's are resolved by a command before they can be read,
// those of the others when they are read.
enum class Multisampling : uint8_t { None, Apple, Ext, Img };

// The sample count of a device that is no less than what was asked for, 0 for 0. -1: there is none.
int sampleCount(const render::Caps& caps, GLsizei asked);

struct Renderbuffer {
  explicit Renderbuffer(GLuint n) : name(n) {}

  const GLuint name;
  GLenum internalFormat = GL_RGBA4_OES;  // as specified
  int width = 0, height = 0;             // pixels
  std::shared_ptr<render::Image> image;  // null: no storage
  std::shared_ptr<SharedImage> shared;   // a sibling of an EGLImage, which is a part of `image`
  int samples = 0;                       // 0: not multisampled
  Multisampling multisampling = Multisampling::None;
  std::string label;

  render::Attachment attachment() const {
    return {image, shared ? shared->level : 0, shared ? shared->layer : 0};
  }
};

// What is attached at one point: a level of a texture, a renderbuffer, or nothing.
struct AttachmentPoint {
  std::shared_ptr<Texture> texture;
  int face = 0;
  int level = 0;
  int slice = 0;  // of a 3D texture
  std::shared_ptr<Renderbuffer> renderbuffer;
  // Of a texture (EXT_multisampled_render_to_texture): it is drawn to through an image with samples.
  int textureSamples = 0;
  Multisampling textureMultisampling = Multisampling::None;
  std::shared_ptr<render::Image> implicit;  // null: not needed yet

  bool empty() const { return !texture && !renderbuffer; }
};

struct FramebufferObject {
  explicit FramebufferObject(GLuint n) : name(n) {}

  const GLuint name;
  AttachmentPoint color, depth, stencil;
  std::string label;
};

// Brings state.framebuffer up to date with the bound framebuffer object: none, when that is not complete, or
// memory ran out. Under the ShareLock.
void updateFramebuffer(Context& c);

// The same for readFramebuffer and the object bound to READ_FRAMEBUFFER_APPLE, which is not null.
bool updateReadFramebuffer(Context& c);

// What forbids ReadPixels and CopyTex...Image; NO_ERROR: nothing, and readFramebuffer is up to date. Under
// the ShareLock.
GLenum readError(Context& c);

inline Fault unreadable() {
  return wrongState(
      "the framebuffer that is read is incomplete or multisampled",
      "Ask glCheckFramebufferStatusOES of READ_FRAMEBUFFER_APPLE why, or make pixels of samples with "
      "glResolveMultisampleFramebufferAPPLE");
}

// A texture or renderbuffer is about to be deleted: it leaves the bound framebuffer object.
void detach(Context& c, const Texture* texture, const Renderbuffer* renderbuffer);

}  // namespace anteroom::gl
