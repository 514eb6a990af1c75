// OES_framebuffer_object and OES_fbo_render_mipmap: framebuffer objects, their attachments and completeness.
#include "layer/gl/framebuffer_object.h"
#include "layer/gl/paletted.h"
#include "layer/gl/texture.h"

namespace anteroom::gl {
namespace {

struct Size {
  int width = 0, height = 0;
};

AttachmentPoint* pointOf(FramebufferObject& object, GLenum attachment) {
  switch (attachment) {
    case GL_COLOR_ATTACHMENT0_OES:
      return &object.color;
    case GL_DEPTH_ATTACHMENT_OES:
      return &object.depth;
    case GL_STENCIL_ATTACHMENT_OES:
      return &object.stencil;
    default:
      return nullptr;
  }
}

Size sizeOf(const AttachmentPoint& point) {
  if (point.renderbuffer) return {point.renderbuffer->width, point.renderbuffer->height};
  const TextureLevel& level = point.texture->at(point.face, point.level);
  return {level.width, level.height};
}

render::Format formatOf(const AttachmentPoint& point) {
  if (!point.renderbuffer) return point.texture->at(point.face, point.level).format;
  const render::Image* image = point.renderbuffer->image.get();
  return image ? image->desc().format : render::Format::None;
}

// Section 4.4.4.1: an image of a size, in a format that suits the attachment point.
bool attachmentComplete(const AttachmentPoint& point, GLenum attachment) {
  const Size size = sizeOf(point);
  if (size.width <= 0 || size.height <= 0) return false;
  const render::Format format = formatOf(point);
  if (format == render::Format::None) return false;
  if (point.texture && isPaletted(point.texture->at(point.face, point.level).internalFormat)) return false;
  const render::FormatInfo& has = render::info(format);
  switch (attachment) {
    case GL_COLOR_ATTACHMENT0_OES:
      return has.red != 0;
    case GL_DEPTH_ATTACHMENT_OES:
      return has.depth != 0;
    default:
      return has.stencil != 0;
  }
}

GLenum statusOf(const Context& c, const FramebufferObject& object) {
  const std::pair<const AttachmentPoint*, GLenum> points[] = {{&object.color, GL_COLOR_ATTACHMENT0_OES},
                                                              {&object.depth, GL_DEPTH_ATTACHMENT_OES},
                                                              {&object.stencil, GL_STENCIL_ATTACHMENT_OES}};
  Size common;
  for (const auto& [point, attachment] : points) {
    if (point->empty()) continue;
    if (!attachmentComplete(*point, attachment)) return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_OES;
  }
  for (const auto& [point, attachment] : points) {
    if (point->empty()) continue;
    const Size size = sizeOf(*point);
    if (common.width != 0 && (size.width != common.width || size.height != common.height)) {
      return GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS_OES;
    }
    common = size;
  }
  if (common.width == 0) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_OES;
  for (const auto& [point, attachment] : points) {
    if (point->empty()) continue;
    if (!c.device.caps().renderable[static_cast<size_t>(formatOf(*point))]) {
      return GL_FRAMEBUFFER_UNSUPPORTED_OES;
    }
  }
  // Depth and stencil lie in one image or there is only one of them.
  const bool both = !object.depth.empty() && !object.stencil.empty();
  if (both && object.depth.renderbuffer != object.stencil.renderbuffer) return GL_FRAMEBUFFER_UNSUPPORTED_OES;
  return GL_FRAMEBUFFER_COMPLETE_OES;
}

// False: out of memory.
bool resolve(Context& c, const AttachmentPoint& point, render::Attachment& out) {
  if (point.empty()) return true;
  if (point.renderbuffer) {
    out = point.renderbuffer->attachment();
  } else {
    out = point.texture->attachment(c, point.face, point.level);
  }
  return out.image != nullptr;
}

bool isAttachment(GLenum attachment) {
  return attachment == GL_COLOR_ATTACHMENT0_OES || attachment == GL_DEPTH_ATTACHMENT_OES ||
         attachment == GL_STENCIL_ATTACHMENT_OES;
}

// The attachment point that a command changes; otherwise null, and the error is set.
AttachmentPoint* changedPoint(Context& c, GLenum target, GLenum attachment) {
  if (target != GL_FRAMEBUFFER_OES || !isAttachment(attachment)) {
    c.setError(GL_INVALID_ENUM);
    return nullptr;
  }
  if (!c.boundFramebuffer) {
    c.setError(GL_INVALID_OPERATION);
    return nullptr;
  }
  return pointOf(*c.boundFramebuffer, attachment);
}

// Other contexts may have it bound, too.
void attachmentsChanged(Context& c) {
  c.group->framebufferVersion.fetch_add(1, std::memory_order_relaxed);
}

void bindFramebuffer(Context& c, std::shared_ptr<FramebufferObject> object) {
  if (c.boundFramebuffer == object) return;
  c.boundFramebuffer = std::move(object);
  c.seenFramebufferVersion = 0;
  if (!c.boundFramebuffer) useDefaultFramebuffer(c);
}

}  // namespace

GLenum framebufferStatus(Context& c) {
  if (c.boundFramebuffer) return statusOf(c, *c.boundFramebuffer);
  return c.hasDefaultFramebuffer ? GL_FRAMEBUFFER_COMPLETE_OES : GL_FRAMEBUFFER_UNDEFINED_OES;
}

bool resolveFramebuffer(Context& c) {
  const uint32_t version = c.group->framebufferVersion.load(std::memory_order_relaxed);
  const uint32_t textures = c.group->textureVersion.load(std::memory_order_relaxed);
  if (c.seenFramebufferVersion == version && c.seenAttachedTextures == textures) return c.hasFramebuffer;

  const FramebufferObject& object = *c.boundFramebuffer;
  render::Framebuffer framebuffer;
  bool complete = statusOf(c, object) == GL_FRAMEBUFFER_COMPLETE_OES;
  if (complete &&
      !(resolve(c, object.color, framebuffer.color) && resolve(c, object.depth, framebuffer.depth) &&
        resolve(c, object.stencil, framebuffer.stencil))) {
    c.setError(GL_OUT_OF_MEMORY);
    complete = false;
  }
  if (complete) {
    for (const AttachmentPoint* point : {&object.color, &object.depth, &object.stencil}) {
      if (point->empty()) continue;
      framebuffer.width = sizeOf(*point).width;
      framebuffer.height = sizeOf(*point).height;
    }
  }
  useFramebuffer(c, complete ? &framebuffer : nullptr);
  c.seenFramebufferVersion = version;
  // Textures that got their image just now raised the version, too.
  c.seenAttachedTextures = c.group->textureVersion.load(std::memory_order_relaxed);
  return complete;
}

void detach(Context& c, const Texture* texture, const Renderbuffer* renderbuffer) {
  if (!c.boundFramebuffer) return;
  FramebufferObject& object = *c.boundFramebuffer;
  for (AttachmentPoint* point : {&object.color, &object.depth, &object.stencil}) {
    const bool attached = (texture && point->texture.get() == texture) ||
                          (renderbuffer && point->renderbuffer.get() == renderbuffer);
    if (!attached) continue;
    *point = {};
    attachmentsChanged(c);
  }
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API GLboolean GL_APIENTRY glIsFramebufferOES(GLuint framebuffer) {
  Context* c = current();
  if (!c || framebuffer == 0) return GL_FALSE;
  ShareLock lock(*c->group);
  return c->group->framebuffers.find(framebuffer) ? GL_TRUE : GL_FALSE;
}

GL_API void GL_APIENTRY glBindFramebufferOES(GLenum target, GLuint framebuffer) {
  Context* c = current();
  if (!c) return;
  if (target != GL_FRAMEBUFFER_OES) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  if (framebuffer == 0) return bindFramebuffer(*c, nullptr);
  std::shared_ptr<FramebufferObject> object = obtain(c->group->framebuffers, framebuffer);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  bindFramebuffer(*c, std::move(object));
}

GL_API void GL_APIENTRY glDeleteFramebuffersOES(GLsizei n, const GLuint* framebuffers) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE);
  if (!framebuffers) return;
  ShareLock lock(*c->group);
  for (GLsizei i = 0; i < n; ++i) {
    if (framebuffers[i] == 0) continue;
    const std::shared_ptr<FramebufferObject> object = c->group->framebuffers.remove(framebuffers[i]);
    if (object && object == c->boundFramebuffer) bindFramebuffer(*c, nullptr);
  }
}

GL_API void GL_APIENTRY glGenFramebuffersOES(GLsizei n, GLuint* framebuffers) {
  Context* c = current();
  if (!c) return;
  if (n < 0) return c->setError(GL_INVALID_VALUE);
  if (!framebuffers) return;
  ShareLock lock(*c->group);
  if (!c->group->framebuffers.reserve(n, framebuffers)) c->setError(GL_OUT_OF_MEMORY);
}

GL_API GLenum GL_APIENTRY glCheckFramebufferStatusOES(GLenum target) {
  Context* c = current();
  if (!c) return 0;
  if (target != GL_FRAMEBUFFER_OES) {
    c->setError(GL_INVALID_ENUM);
    return 0;
  }
  ShareLock lock(*c->group);
  return framebufferStatus(*c);
}

GL_API void GL_APIENTRY glFramebufferTexture2DOES(GLenum target, GLenum attachment, GLenum textarget,
                                                  GLuint texture, GLint level) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  AttachmentPoint* point = changedPoint(*c, target, attachment);
  if (!point) return;
  AttachmentPoint attached;
  if (texture != 0) {
    const ImageTarget image = imageTarget(textarget);
    if (image.slot == kSlotCount) return c->setError(GL_INVALID_ENUM);
    attached.texture = c->group->textures.find(texture);
    if (!attached.texture || attached.texture->slot != image.slot) return c->setError(GL_INVALID_OPERATION);
    // OES_fbo_render_mipmap: any level that there can be.
    if (level < 0 || level >= attached.texture->levels()) return c->setError(GL_INVALID_VALUE);
    attached.face = image.face;
    attached.level = level;
  }
  *point = std::move(attached);
  attachmentsChanged(*c);
}

GL_API void GL_APIENTRY glFramebufferRenderbufferOES(GLenum target, GLenum attachment,
                                                     GLenum renderbuffertarget, GLuint renderbuffer) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  AttachmentPoint* point = changedPoint(*c, target, attachment);
  if (!point) return;
  AttachmentPoint attached;
  if (renderbuffer != 0) {
    if (renderbuffertarget != GL_RENDERBUFFER_OES) return c->setError(GL_INVALID_ENUM);
    attached.renderbuffer = c->group->renderbuffers.find(renderbuffer);
    if (!attached.renderbuffer) return c->setError(GL_INVALID_OPERATION);
  }
  *point = std::move(attached);
  attachmentsChanged(*c);
}

GL_API void GL_APIENTRY glGetFramebufferAttachmentParameterivOES(GLenum target, GLenum attachment,
                                                                 GLenum pname, GLint* params) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  const AttachmentPoint* point = changedPoint(*c, target, attachment);
  if (!point || !params) return;
  if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES) {
    *params = point->texture ? GL_TEXTURE : point->renderbuffer ? GL_RENDERBUFFER_OES : GL_NONE_OES;
    return;
  }
  if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES && !point->empty()) {
    *params = static_cast<GLint>(point->texture ? point->texture->name : point->renderbuffer->name);
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES && point->texture) {
    *params = point->level;
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES && point->texture) {
    *params = point->texture->slot == kSlotCube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + point->face : 0;
  } else {
    c->setError(GL_INVALID_ENUM);
  }
}

GL_API void GL_APIENTRY glGenerateMipmapOES(GLenum target) {
  Context* c = current();
  if (!c) return;
  const TextureSlot slot = bindingSlot(target);
  if (slot == kSlotCount || slot == kSlotExternal) return c->setError(GL_INVALID_ENUM);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, slot);
  if (!texture.canGenerateMipmaps()) return c->setError(GL_INVALID_OPERATION);
  if (!texture.generateMipmaps(*c)) c->setError(GL_OUT_OF_MEMORY);
}

// EXT_discard_framebuffer. Contents that need not be kept may be kept.
GL_API void GL_APIENTRY glDiscardFramebufferEXT(GLenum target, GLsizei numAttachments,
                                                const GLenum* attachments) {
  Context* c = current();
  if (!c) return;
  if (target != GL_FRAMEBUFFER_OES) return c->setError(GL_INVALID_ENUM);
  if (numAttachments < 0) return c->setError(GL_INVALID_VALUE);
  for (GLsizei i = 0; attachments && i < numAttachments; ++i) {
    const GLenum name = attachments[i];
    const bool known = c->boundFramebuffer
                           ? isAttachment(name)
                           : name == GL_COLOR_EXT || name == GL_DEPTH_EXT || name == GL_STENCIL_EXT;
    if (!known) return c->setError(GL_INVALID_ENUM);
  }
}
