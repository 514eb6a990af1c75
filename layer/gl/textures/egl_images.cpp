// OES_EGL_image and OES_EGL_image_external: textures and renderbuffers from EGLImages; and the sources of
// EGLImages (EGL 1.5 section 3.9).
#include <new>

#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/pixel.h"
#include "layer/gl/textures/texture.h"

namespace anteroom::gl {
namespace {

std::shared_ptr<SharedImage> findImage(const Context& c, GLeglImageOES image) {
  return c.options.findImage ? c.options.findImage(c.options.display, image) : nullptr;
}

ShareStatus shareRenderbuffer(Context& c, GLuint name, std::shared_ptr<SharedImage>& image) {
  const std::shared_ptr<Renderbuffer> source = c.group->renderbuffers.find(name);
  if (!source || !source->image || source->image->desc().samples > 1) return ShareStatus::NoSource;
  if (source->shared && !isAlone(source->shared)) return ShareStatus::Taken;
  const render::Attachment at = source->attachment();
  try {
    image =
        std::make_shared<SharedImage>(SharedImage{at.image, at.level, at.layer, source->width, source->height,
                                                  pixelFormatOf(at.image->desc().format).format});
  } catch (const std::bad_alloc&) {
    return ShareStatus::OutOfMemory;
  }
  source->shared = image;
  return ShareStatus::Shared;
}

// What RENDERBUFFER_INTERNAL_FORMAT_OES says of a format that can be rendered to. 0: this one cannot.
GLenum renderbufferFormat(const Context& c, render::Format format) {
  if (!c.device.caps().renderable[static_cast<size_t>(format)]) return 0;
  switch (format) {
    case render::Format::RGB565:
      return GL_RGB565_OES;
    case render::Format::RGBA4444:
      return GL_RGBA4_OES;
    case render::Format::RGBA5551:
      return GL_RGB5_A1_OES;
    case render::Format::RGB8:
      return GL_RGB8_OES;
    case render::Format::RGBA8:
      return GL_RGBA8_OES;
    case render::Format::SRGB8Alpha8:
      return GL_SRGB8_ALPHA8_EXT;
    case render::Format::Depth16:
      return GL_DEPTH_COMPONENT16_OES;
    case render::Format::Depth24:
      return GL_DEPTH_COMPONENT24_OES;
    case render::Format::Depth32:
      return GL_DEPTH_COMPONENT32_OES;
    case render::Format::Depth24Stencil8:
      return GL_DEPTH24_STENCIL8_OES;
    case render::Format::Stencil8:
      return GL_STENCIL_INDEX8_OES;
    default:
      return 0;
  }
}

Fault noImage() {
  return wrongState("image is no EGLImage of this context's display",
                    "Make one with eglCreateImage, and use it before eglDestroyImage");
}

}  // namespace

void shareImages(ShareGroup& group) {
  if (group.sharesImages.load(std::memory_order_relaxed)) return;
  std::unique_lock<std::mutex> lock(group.mutex, std::defer_lock);
  if (group.contexts.load(std::memory_order_acquire) > 1) lock.lock();
  group.sharesImages.store(true, std::memory_order_release);
}

void shareImages(Context& c) {
  shareImages(*c.group);
}

ShareStatus shareImage(Context& c, const ImageSource& source, std::shared_ptr<SharedImage>& image) {
  shareImages(*c.group);
  ShareLock lock(*c.group);
  ShareStatus status = ShareStatus::NoSource;
  if (source.target == GL_RENDERBUFFER_OES) {
    status = shareRenderbuffer(c, source.name, image);
  } else {
    const ImageTarget target = imageTarget(source.target);
    const std::shared_ptr<Texture> texture = c.group->textures.find(source.name);
    if (texture && texture->slot == target.slot) {
      status = texture->share(c, target.face, source.level, image);
    }
  }
  // The context may not be current: nobody else would submit what was done.
  c.renderer->flush();
  return status;
}

bool hasCompany(const Context& c) {
  return c.group->contexts.load(std::memory_order_relaxed) > 1;
}

}  // namespace anteroom::gl

using namespace anteroom::gl;
namespace gen = anteroom::gen;
namespace render = anteroom::render;

GL_API void GL_APIENTRY glEGLImageTargetTexture2DOES(GLenum target, GLeglImageOES image) {
  Context* c = current();
  if (!c) return;
  if (target != GL_TEXTURE_2D && target != GL_TEXTURE_EXTERNAL_OES)
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("target", target, "Use TEXTURE_2D or TEXTURE_EXTERNAL_OES"));
  const std::shared_ptr<SharedImage> shared = findImage(*c, image);
  if (!shared) return c->setError(GL_INVALID_VALUE, noImage());
  if (render::isDepthOrStencil(shared->image->desc().format))
    return c->setError(GL_INVALID_OPERATION, wrongState("The image shows depth or stencil",
                                                        "Define a renderbuffer by it, not a texture"));
  shareImages(*c->group);
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, bindingSlot(target));
  if (texture.immutable())  // EXT_texture_storage
    return c->setError(GL_INVALID_OPERATION, wrongState("The bound texture has immutable storage",
                                                        "Bind a texture without TexStorage2DEXT"));
  texture.adopt(*c, shared);
}

GL_API void GL_APIENTRY glEGLImageTargetRenderbufferStorageOES(GLenum target, GLeglImageOES image) {
  Context* c = current();
  if (!c) return;
  if (target != GL_RENDERBUFFER_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, "Use RENDERBUFFER_OES"));
  const std::shared_ptr<SharedImage> shared = findImage(*c, image);
  if (!shared) return c->setError(GL_INVALID_VALUE, noImage());
  const GLenum internalFormat = renderbufferFormat(*c, shared->image->desc().format);
  shareImages(*c->group);
  ShareLock lock(*c->group);
  Renderbuffer* renderbuffer = c->boundRenderbuffer.get();
  if (!renderbuffer)
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("No renderbuffer is bound", "Bind one with glBindRenderbufferOES first"));
  if (internalFormat == 0)
    return c->setError(GL_INVALID_OPERATION, wrongState("Nothing can be rendered to the image's format",
                                                        "Make it of an RGB or RGBA texture"));
  renderbuffer->internalFormat = internalFormat;
  renderbuffer->width = shared->width;
  renderbuffer->height = shared->height;
  renderbuffer->image = shared->image;
  renderbuffer->shared = shared;
  renderbuffer->samples = 0;
  renderbuffer->multisampling = Multisampling::None;
  c->group->tell(gen::kGroupFramebuffer);
}
