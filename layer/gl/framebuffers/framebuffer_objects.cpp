// OES_framebuffer_object and OES_fbo_render_mipmap: framebuffer objects, their attachments and completeness.
#include "layer/gl/framebuffers/framebuffer_object.h"

#include <algorithm>
#include <utility>

#include "layer/gl/context/object_commands.h"
#include "layer/gl/textures/texture.h"

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
  if (point.texture && isCompressed(point.texture->at(point.face, point.level).internalFormat)) return false;
  if (point.texture && point.slice >= point.texture->at(point.face, point.level).depth) return false;
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

int samplesOf(const AttachmentPoint& point) {
  return point.renderbuffer ? point.renderbuffer->samples : point.textureSamples;
}

Multisampling multisamplingOf(const AttachmentPoint& point) {
  return point.renderbuffer ? point.renderbuffer->multisampling : point.textureMultisampling;
}

// The extensions give the same fault different numbers.
GLenum unlikeSamples(const FramebufferObject& object) {
  const bool img = multisamplingOf(object.color) == Multisampling::Img ||
                   multisamplingOf(object.depth) == Multisampling::Img ||
                   multisamplingOf(object.stencil) == Multisampling::Img;
  return img ? GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_IMG : GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE_EXT;
}

GLenum statusOf(const Context& c, const FramebufferObject& object) {
  const std::pair<const AttachmentPoint*, GLenum> points[] = {{&object.color, GL_COLOR_ATTACHMENT0_OES},
                                                              {&object.depth, GL_DEPTH_ATTACHMENT_OES},
                                                              {&object.stencil, GL_STENCIL_ATTACHMENT_OES}};
  Size common;
  int samples = -1;
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
    if (samples >= 0 && samplesOf(*point) != samples) return unlikeSamples(object);
    samples = samplesOf(*point);
  }
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

// What a point attaches, if anything. False: out of memory.
bool attach(Context& c, const AttachmentPoint& point, render::Attachment& out) {
  if (point.empty()) return true;
  if (point.renderbuffer) {
    out = point.renderbuffer->attachment();
  } else {
    out = point.texture->attachment(c, point.face, point.level, point.slice);
  }
  return out.image != nullptr;
}

// The image with samples through which a texture is drawn to. False: out of memory.
bool addSamples(Context& c, AttachmentPoint& point, render::Framebuffer& framebuffer) {
  if (point.textureSamples == 0) return true;
  render::ImageDesc desc;
  desc.format = framebuffer.color.image->desc().format;
  desc.width = framebuffer.width;
  desc.height = framebuffer.height;
  desc.samples = point.textureSamples;
  desc.renderable = true;
  const render::ImageDesc* had = point.implicit ? &point.implicit->desc() : nullptr;
  if (!had || had->format != desc.format || had->width != desc.width || had->height != desc.height)
    point.implicit = c.device.createImage(desc);
  framebuffer.resolve = std::exchange(framebuffer.color, render::Attachment{point.implicit, 0, 0});
  return point.implicit != nullptr;
}

// What a framebuffer object is to a renderer; its textures get images. False: it is not complete, or memory
// ran out.
bool makeFramebuffer(Context& c, FramebufferObject& object, render::Framebuffer& framebuffer) {
  framebuffer = {};
  if (statusOf(c, object) != GL_FRAMEBUFFER_COMPLETE_OES) return false;
  for (const AttachmentPoint* point : {&object.color, &object.depth, &object.stencil}) {
    if (point->empty()) continue;
    framebuffer.width = sizeOf(*point).width;
    framebuffer.height = sizeOf(*point).height;
    framebuffer.samples = std::max(samplesOf(*point), 1);
  }
  if (attach(c, object.color, framebuffer.color) && attach(c, object.depth, framebuffer.depth) &&
      attach(c, object.stencil, framebuffer.stencil) && addSamples(c, object.color, framebuffer))
    return true;
  c.setError(GL_OUT_OF_MEMORY);
  framebuffer = {};
  return false;
}

bool isAttachment(GLenum attachment) {
  return attachment == GL_COLOR_ATTACHMENT0_OES || attachment == GL_DEPTH_ATTACHMENT_OES ||
         attachment == GL_STENCIL_ATTACHMENT_OES;
}

bool isFramebufferTarget(GLenum target) {
  return target == GL_FRAMEBUFFER_OES || target == GL_DRAW_FRAMEBUFFER_APPLE ||
         target == GL_READ_FRAMEBUFFER_APPLE;
}
constexpr const char* kTargets = "Use FRAMEBUFFER_OES, or READ_FRAMEBUFFER_APPLE or DRAW_FRAMEBUFFER_APPLE";

// FRAMEBUFFER_OES means the one that is drawn to.
FramebufferObject* objectAt(Context& c, GLenum target) {
  return target == GL_READ_FRAMEBUFFER_APPLE ? c.boundReadFramebuffer.get() : c.boundFramebuffer.get();
}

// The attachment point that a command names; otherwise null, and the error is set.
AttachmentPoint* attachmentPoint(Context& c, GLenum target, GLenum attachment,
                                 const char* command = __builtin_FUNCTION()) {
  if (!isFramebufferTarget(target)) {
    c.setError(GL_INVALID_ENUM, wrongEnum("target", target, kTargets), command);
    return nullptr;
  }
  if (!isAttachment(attachment)) {
    c.setError(GL_INVALID_ENUM,
               wrongEnum("attachment", attachment,
                         "Use COLOR_ATTACHMENT0_OES, DEPTH_ATTACHMENT_OES or STENCIL_ATTACHMENT_OES"),
               command);
    return nullptr;
  }
  FramebufferObject* object = objectAt(c, target);
  if (!object) {
    c.setError(GL_INVALID_OPERATION,
               wrongState("The default framebuffer is bound, which has no attachments",
                          "Bind a framebuffer object with glBindFramebufferOES first"),
               command);
    return nullptr;
  }
  return pointOf(*object, attachment);
}

// Other contexts may have it bound, too.
void attachmentsChanged(Context& c) {
  c.group->tell(gen::kGroupFramebuffer);
}

void bindDraw(Context& c, std::shared_ptr<FramebufferObject> object) {
  if (c.boundFramebuffer == object) return;
  c.boundFramebuffer = std::move(object);
  c.told |= gen::kGroupFramebuffer;
  if (!c.boundFramebuffer) useDefaultFramebuffer(c);
}

void unbind(Context& c, const std::shared_ptr<FramebufferObject>& object) {
  if (object == c.boundReadFramebuffer) c.boundReadFramebuffer.reset();
  if (object == c.boundFramebuffer) bindDraw(c, nullptr);
}

// FramebufferTexture2DOES, FramebufferTexture3DOES, and with samples those of EXT and IMG. `image`: what the
// command takes textarget for. Arguments that concern samples are valid.
void attachTexture(Context& c, GLenum target, GLenum attachment, GLenum textarget, const ImageTarget& image,
                   GLuint texture, GLint level, GLint slice, int samples, Multisampling multisampling,
                   const char* command = __builtin_FUNCTION()) {
  AttachmentPoint* point = attachmentPoint(c, target, attachment, command);
  if (!point) return;
  AttachmentPoint attached;
  if (texture != 0) {
    if (image.slot == kSlotCount)
      return c.setError(GL_INVALID_ENUM,
                        wrongEnum("textarget", textarget,
                                  "Use TEXTURE_2D or a face such as TEXTURE_CUBE_MAP_POSITIVE_X_OES, for "
                                  "slices TEXTURE_3D_OES"),
                        command);
    attached.texture = c.group->textures.find(texture);
    if (!attached.texture || attached.texture->slot != image.slot)
      return c.setError(GL_INVALID_OPERATION,
                        wrongNumber("texture", texture,
                                    "Give a texture that has been bound to the target that textarget names"),
                        command);
    // OES_fbo_render_mipmap: any level that there can be.
    if (level < 0 || level >= attached.texture->levels())
      return c.setError(GL_INVALID_VALUE,
                        wrongNumber("level", level, "Give a level from 0 to log2 of the largest size"),
                        command);
    if (slice < 0 || slice >= std::max(c.device.caps().maxVolumeSize, 1))
      return c.setError(GL_INVALID_VALUE,
                        wrongNumber("zoffset", slice, "Give a slice that a texture can have"), command);
    attached.face = image.face;
    attached.slice = slice;
    attached.level = level;
    attached.textureSamples = samples;
    attached.textureMultisampling = multisampling;
  }
  *point = std::move(attached);
  attachmentsChanged(c);
}

// FramebufferTexture2DMultisampleEXT and ...IMG.
void attachTextureWithSamples(Context& c, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                              GLint level, GLsizei samples, Multisampling multisampling,
                              const char* command = __builtin_FUNCTION()) {
  ShareLock lock(*c.group);
  if (isFramebufferTarget(target) && attachment != GL_COLOR_ATTACHMENT0_OES)
    return c.setError(
        GL_INVALID_ENUM,
        wrongEnum("attachment", attachment, "Textures get samples at COLOR_ATTACHMENT0_OES alone"), command);
  const int count = sampleCount(c.device.caps(), samples);
  if (count < 0)
    return c.setError(GL_INVALID_VALUE,
                      wrongNumber("samples", samples, "Give a count from 0 to the value of MAX_SAMPLES_EXT"),
                      command);
  attachTexture(c, target, attachment, textarget, imageTarget(textarget), texture, level, 0, count,
                count > 0 ? multisampling : Multisampling::None, command);
}

}  // namespace

int sampleCount(const render::Caps& caps, GLsizei asked) {
  if (asked == 0) return 0;
  return asked > 0 && caps.maxSamples > 1 && asked <= caps.maxSamples ? caps.maxSamples : -1;
}

void updateFramebuffer(Context& c) {
  render::Framebuffer framebuffer;
  const bool complete = makeFramebuffer(c, *c.boundFramebuffer, framebuffer);
  useFramebuffer(c, complete ? &framebuffer : nullptr);
}

bool updateReadFramebuffer(Context& c) {
  if (c.boundReadFramebuffer != c.boundFramebuffer)
    return makeFramebuffer(c, *c.boundReadFramebuffer, c.readFramebuffer);
  const bool complete = c.framebufferComplete();
  c.readFramebuffer = c.state.framebuffer;
  return complete;
}

GLenum readError(Context& c) {
  if (!c.readFramebufferComplete()) return GL_INVALID_FRAMEBUFFER_OPERATION_OES;
  if (!c.boundReadFramebuffer || c.readFramebuffer.samples <= 1) return GL_NO_ERROR;
  return multisamplingOf(c.boundReadFramebuffer->color) == Multisampling::Apple ? GL_INVALID_OPERATION
                                                                                : GL_NO_ERROR;
}

void detach(Context& c, const Texture* texture, const Renderbuffer* renderbuffer) {
  for (FramebufferObject* object : {c.boundFramebuffer.get(), c.boundReadFramebuffer.get()}) {
    if (!object) continue;
    for (AttachmentPoint* point : {&object->color, &object->depth, &object->stencil}) {
      const bool attached = (texture && point->texture.get() == texture) ||
                            (renderbuffer && point->renderbuffer.get() == renderbuffer);
      if (!attached) continue;
      *point = {};
      attachmentsChanged(c);
    }
  }
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API GLboolean GL_APIENTRY glIsFramebufferOES(GLuint framebuffer) {
  return isObject(&ShareGroup::framebuffers, framebuffer);
}

GL_API void GL_APIENTRY glBindFramebufferOES(GLenum target, GLuint framebuffer) {
  Context* c = current();
  if (!c) return;
  if (!isFramebufferTarget(target))
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, kTargets));
  ShareLock lock(*c->group);
  std::shared_ptr<FramebufferObject> object;
  if (framebuffer != 0) {
    object = obtain(c->group->framebuffers, framebuffer);
    if (!object) return c->setError(GL_OUT_OF_MEMORY);
  }
  if (target != GL_DRAW_FRAMEBUFFER_APPLE) c->boundReadFramebuffer = object;
  if (target != GL_READ_FRAMEBUFFER_APPLE) bindDraw(*c, std::move(object));
}

GL_API void GL_APIENTRY glDeleteFramebuffersOES(GLsizei n, const GLuint* framebuffers) {
  deleteObjects(&ShareGroup::framebuffers, n, framebuffers, unbind);
}

GL_API void GL_APIENTRY glGenFramebuffersOES(GLsizei n, GLuint* framebuffers) {
  generateNames(&ShareGroup::framebuffers, n, framebuffers);
}

GL_API GLenum GL_APIENTRY glCheckFramebufferStatusOES(GLenum target) {
  Context* c = current();
  if (!c) return 0;
  if (!isFramebufferTarget(target)) {
    c->setError(GL_INVALID_ENUM, wrongEnum("target", target, kTargets));
    return 0;
  }
  ShareLock lock(*c->group);
  if (const FramebufferObject* object = objectAt(*c, target)) return statusOf(*c, *object);
  return c->hasDefaultFramebuffer ? GL_FRAMEBUFFER_COMPLETE_OES : GL_FRAMEBUFFER_UNDEFINED_OES;
}

GL_API void GL_APIENTRY glFramebufferTexture2DOES(GLenum target, GLenum attachment, GLenum textarget,
                                                  GLuint texture, GLint level) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  attachTexture(*c, target, attachment, textarget, imageTarget(textarget), texture, level, 0, 0,
                Multisampling::None);
}

// OES_texture_3D.
GL_API void GL_APIENTRY glFramebufferTexture3DOES(GLenum target, GLenum attachment, GLenum textarget,
                                                  GLuint texture, GLint level, GLint zoffset) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  const ImageTarget volume{textarget == GL_TEXTURE_3D_OES ? kSlot3D : kSlotCount};
  attachTexture(*c, target, attachment, textarget, volume, texture, level, zoffset, 0, Multisampling::None);
}

GL_API void GL_APIENTRY glFramebufferTexture2DMultisampleEXT(GLenum target, GLenum attachment,
                                                             GLenum textarget, GLuint texture, GLint level,
                                                             GLsizei samples) {
  Context* c = current();
  if (!c) return;
  attachTextureWithSamples(*c, target, attachment, textarget, texture, level, samples, Multisampling::Ext);
}

GL_API void GL_APIENTRY glFramebufferTexture2DMultisampleIMG(GLenum target, GLenum attachment,
                                                             GLenum textarget, GLuint texture, GLint level,
                                                             GLsizei samples) {
  Context* c = current();
  if (!c) return;
  if (target != GL_FRAMEBUFFER_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, "Use FRAMEBUFFER_OES"));
  attachTextureWithSamples(*c, target, attachment, textarget, texture, level, samples, Multisampling::Img);
}

GL_API void GL_APIENTRY glFramebufferRenderbufferOES(GLenum target, GLenum attachment,
                                                     GLenum renderbuffertarget, GLuint renderbuffer) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  AttachmentPoint* point = attachmentPoint(*c, target, attachment);
  if (!point) return;
  AttachmentPoint attached;
  if (renderbuffer != 0) {
    if (renderbuffertarget != GL_RENDERBUFFER_OES)
      return c->setError(GL_INVALID_ENUM,
                         wrongEnum("renderbuffertarget", renderbuffertarget, "Use RENDERBUFFER_OES"));
    attached.renderbuffer = c->group->renderbuffers.find(renderbuffer);
    if (!attached.renderbuffer)
      return c->setError(GL_INVALID_OPERATION, wrongNumber("renderbuffer", renderbuffer,
                                                           "Bind the name with glBindRenderbufferOES first"));
  }
  *point = std::move(attached);
  attachmentsChanged(*c);
}

GL_API void GL_APIENTRY glGetFramebufferAttachmentParameterivOES(GLenum target, GLenum attachment,
                                                                 GLenum pname, GLint* params) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  const AttachmentPoint* point = attachmentPoint(*c, target, attachment);
  if (!point) return;
  GLint value = 0;
  if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES) {
    value = point->texture ? GL_TEXTURE : point->renderbuffer ? GL_RENDERBUFFER_OES : GL_NONE_OES;
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING_EXT && !point->empty()) {
    value = anteroom::render::isSrgb(formatOf(*point)) ? GL_SRGB_EXT : GL_LINEAR;
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_OES && !point->empty()) {
    value = static_cast<GLint>(point->texture ? point->texture->name : point->renderbuffer->name);
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_OES && point->texture) {
    value = point->level;
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_OES && point->texture) {
    value = point->texture->slot == kSlotCube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + point->face : 0;
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_3D_ZOFFSET_OES && point->texture) {
    value = point->slice;
  } else if ((pname == GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT || pname == GL_TEXTURE_SAMPLES_IMG) &&
             point->texture) {
    value = point->textureSamples;
  } else {
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("pname", pname,
                                 "Ask for FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES first: what is "
                                 "attached decides what else can be asked"));
  }
  if (params) *params = value;
}

GL_API void GL_APIENTRY glGenerateMipmapOES(GLenum target) {
  Context* c = current();
  if (!c) return;
  const TextureSlot slot = bindingSlot(target);
  if (slot == kSlotCount || slot == kSlotExternal)
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("target", target, "Use TEXTURE_2D or TEXTURE_CUBE_MAP_OES"));
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, slot);
  if (!texture.canGenerateMipmaps())
    return c->setError(
        GL_INVALID_OPERATION,
        wrongState("Level 0 of the bound texture is missing, or the faces of the cube map differ",
                   "Specify level 0 of every face alike before"));
  if (!texture.generateMipmaps(*c)) c->setError(GL_OUT_OF_MEMORY);
}

// EXT_discard_framebuffer. Contents that need not be kept may be kept.
GL_API void GL_APIENTRY glDiscardFramebufferEXT(GLenum target, GLsizei numAttachments,
                                                const GLenum* attachments) {
  Context* c = current();
  if (!c) return;
  if (!isFramebufferTarget(target))
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, kTargets));
  if (numAttachments < 0)
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber("numAttachments", numAttachments, "Give a count from 0 on"));
  for (GLsizei i = 0; attachments && i < numAttachments; ++i) {
    const GLenum name = attachments[i];
    const bool known = objectAt(*c, target)
                           ? isAttachment(name)
                           : name == GL_COLOR_EXT || name == GL_DEPTH_EXT || name == GL_STENCIL_EXT;
    if (!known)
      return c->setError(GL_INVALID_ENUM,
                         wrongEnum("an element of attachments", name,
                                   "Use ..._ATTACHMENT_OES for a framebuffer object, COLOR_EXT, "
                                   "DEPTH_EXT and STENCIL_EXT for the default framebuffer"));
  }
}
