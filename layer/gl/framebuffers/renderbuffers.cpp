// OES_framebuffer_object: renderbuffers; their formats also of OES_rgb8_rgba8, ARM_rgba8, EXT_sRGB,
// OES_depth24, OES_depth32, OES_stencil1, 4 and 8, and OES_packed_depth_stencil.
#include <algorithm>

#include "layer/gl/context/object_commands.h"
#include "layer/gl/debug/tool_names.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/queries/query.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;
namespace render = anteroom::render;
using render::Format;

namespace {

// None: not an internal format of renderbuffers. Fewer stencil bits are not offered: it has 8.
Format formatOf(GLenum internalFormat) {
  switch (internalFormat) {
    case GL_RGB565_OES:
      return Format::RGB565;
    case GL_RGBA4_OES:
      return Format::RGBA4444;
    case GL_RGB5_A1_OES:
      return Format::RGBA5551;
    case GL_RGB8_OES:
      return Format::RGB8;
    case GL_RGBA8_OES:
      return Format::RGBA8;
    case GL_SRGB8_ALPHA8_EXT:
      return Format::SRGB8Alpha8;
    case GL_DEPTH_COMPONENT16_OES:
      return Format::Depth16;
    case GL_DEPTH_COMPONENT24_OES:
      return Format::Depth24;
    case GL_DEPTH_COMPONENT32_OES:
      return Format::Depth32;
    case GL_DEPTH24_STENCIL8_OES:
      return Format::Depth24Stencil8;
    case GL_STENCIL_INDEX1_OES:
    case GL_STENCIL_INDEX4_OES:
    case GL_STENCIL_INDEX8_OES:
      return Format::Stencil8;
    default:
      return Format::None;
  }
}

// The renderable format that has at least what was asked for.
Format renderableFormat(const render::Caps& caps, Format format) {
  if (caps.renderable[static_cast<size_t>(format)]) return format;
  switch (format) {
    case Format::RGB565:
      return Format::RGB8;
    case Format::RGBA4444:
    case Format::RGBA5551:
      return Format::RGBA8;
    case Format::Depth24:
    case Format::Stencil8:
      return Format::Depth24Stencil8;
    default:
      return format;
  }
}

// RenderbufferStorageOES, and with samples those of APPLE, EXT and IMG.
void specifyStorage(GLenum target, GLsizei samples, GLenum internalformat, GLsizei width, GLsizei height,
                    Multisampling multisampling, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const Format asked = formatOf(internalformat);
  if (target != GL_RENDERBUFFER_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, "Use RENDERBUFFER_OES"), command);
  const bool lacked =
      asked == Format::Depth32 && !c->device.caps().renderable[static_cast<size_t>(Format::Depth32)];
  if (asked == Format::None || lacked)
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("internalformat", internalformat,
                                 "Use a sized format such as RGBA8_OES, RGB565_OES or DEPTH24_STENCIL8_OES"),
                       command);
  const render::Caps& caps = c->device.caps();
  const auto fits = [&](GLsizei size) { return size >= 0 && size <= caps.maxTextureSize; };
  if (!fits(width) || !fits(height))
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber(fits(width) ? "height" : "width", fits(width) ? height : width,
                                   "Give a size from 0 to the value of MAX_RENDERBUFFER_SIZE_OES"),
                       command);
  const int count = sampleCount(caps, samples);
  if (count < 0)
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber("samples", samples, "Give a count from 0 to the value of MAX_SAMPLES_EXT"),
                       command);
  ShareLock lock(*c->group);
  Renderbuffer* renderbuffer = c->boundRenderbuffer.get();
  if (!renderbuffer)
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("No renderbuffer is bound", "Bind one with glBindRenderbufferOES first"),
                       command);
  std::shared_ptr<render::Image> image;
  if (width != 0 && height != 0) {
    render::ImageDesc desc;
    desc.format = renderableFormat(caps, asked);
    desc.width = width;
    desc.height = height;
    desc.samples = std::max(count, 1);
    desc.renderable = true;
    image = c->device.createImage(desc);
    if (!image) return c->setError(GL_OUT_OF_MEMORY, {}, command);
    nameImage(*c, *image, "renderbuffer", renderbuffer->name, renderbuffer->label);
  }
  renderbuffer->internalFormat = internalformat;
  renderbuffer->width = width;
  renderbuffer->height = height;
  renderbuffer->image = std::move(image);
  renderbuffer->shared.reset();
  renderbuffer->samples = count;
  renderbuffer->multisampling = count > 0 ? multisampling : Multisampling::None;
  c->group->tell(gen::kGroupFramebuffer);
}

render::FormatInfo bitsOf(const Renderbuffer& r) {
  return r.image ? render::info(r.image->desc().format) : render::FormatInfo{};
}

using enum Results::Kind;

// OES_framebuffer_object, EXT_multisampled_render_to_texture, IMG_multisampled_render_to_texture.
constexpr auto kRenderbufferQueries = tableOf<Query<Renderbuffer>>({
    {GL_RENDERBUFFER_WIDTH_OES, Integer, [](Renderbuffer& r) { return r.width; }},
    {GL_RENDERBUFFER_HEIGHT_OES, Integer, [](Renderbuffer& r) { return r.height; }},
    {GL_RENDERBUFFER_INTERNAL_FORMAT_OES, Enum, [](Renderbuffer& r) { return r.internalFormat; }},
    {GL_RENDERBUFFER_RED_SIZE_OES, Integer, [](Renderbuffer& r) { return bitsOf(r).red; }},
    {GL_RENDERBUFFER_GREEN_SIZE_OES, Integer, [](Renderbuffer& r) { return bitsOf(r).green; }},
    {GL_RENDERBUFFER_BLUE_SIZE_OES, Integer, [](Renderbuffer& r) { return bitsOf(r).blue; }},
    {GL_RENDERBUFFER_ALPHA_SIZE_OES, Integer, [](Renderbuffer& r) { return bitsOf(r).alpha; }},
    {GL_RENDERBUFFER_DEPTH_SIZE_OES, Integer, [](Renderbuffer& r) { return bitsOf(r).depth; }},
    {GL_RENDERBUFFER_STENCIL_SIZE_OES, Integer, [](Renderbuffer& r) { return bitsOf(r).stencil; }},
    {GL_RENDERBUFFER_SAMPLES_EXT, Integer, [](Renderbuffer& r) { return r.samples; }},
    {GL_RENDERBUFFER_SAMPLES_IMG, Integer, [](Renderbuffer& r) { return r.samples; }},
});

void unbind(Context& c, const std::shared_ptr<Renderbuffer>& object) {
  if (c.boundRenderbuffer == object) c.boundRenderbuffer.reset();
  detach(c, nullptr, object.get());
}

}  // namespace

GL_API GLboolean GL_APIENTRY glIsRenderbufferOES(GLuint renderbuffer) {
  return isObject(&ShareGroup::renderbuffers, renderbuffer);
}

GL_API void GL_APIENTRY glBindRenderbufferOES(GLenum target, GLuint renderbuffer) {
  Context* c = current();
  if (!c) return;
  if (target != GL_RENDERBUFFER_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, "Use RENDERBUFFER_OES"));
  ShareLock lock(*c->group);
  if (renderbuffer == 0) return c->boundRenderbuffer.reset();
  std::shared_ptr<Renderbuffer> object = obtain(c->group->renderbuffers, renderbuffer);
  if (!object) return c->setError(GL_OUT_OF_MEMORY);
  c->boundRenderbuffer = std::move(object);
}

GL_API void GL_APIENTRY glDeleteRenderbuffersOES(GLsizei n, const GLuint* renderbuffers) {
  deleteObjects(&ShareGroup::renderbuffers, n, renderbuffers, unbind);
}

GL_API void GL_APIENTRY glGenRenderbuffersOES(GLsizei n, GLuint* renderbuffers) {
  generateNames(&ShareGroup::renderbuffers, n, renderbuffers);
}

GL_API void GL_APIENTRY glRenderbufferStorageOES(GLenum target, GLenum internalformat, GLsizei width,
                                                 GLsizei height) {
  specifyStorage(target, 0, internalformat, width, height, Multisampling::None);
}

GL_API void GL_APIENTRY glRenderbufferStorageMultisampleAPPLE(GLenum target, GLsizei samples,
                                                              GLenum internalformat, GLsizei width,
                                                              GLsizei height) {
  specifyStorage(target, samples, internalformat, width, height, Multisampling::Apple);
}

GL_API void GL_APIENTRY glRenderbufferStorageMultisampleEXT(GLenum target, GLsizei samples,
                                                            GLenum internalformat, GLsizei width,
                                                            GLsizei height) {
  specifyStorage(target, samples, internalformat, width, height, Multisampling::Ext);
}

GL_API void GL_APIENTRY glRenderbufferStorageMultisampleIMG(GLenum target, GLsizei samples,
                                                            GLenum internalformat, GLsizei width,
                                                            GLsizei height) {
  specifyStorage(target, samples, internalformat, width, height, Multisampling::Img);
}

GL_API void GL_APIENTRY glGetRenderbufferParameterivOES(GLenum target, GLenum pname, GLint* params) {
  Context* c = current();
  if (!c) return;
  if (target != GL_RENDERBUFFER_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("target", target, "Use RENDERBUFFER_OES"));
  ShareLock lock(*c->group);
  Renderbuffer* renderbuffer = c->boundRenderbuffer.get();
  if (!renderbuffer)
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("No renderbuffer is bound", "Bind one with glBindRenderbufferOES first"));
  Results results(params, Results::Form::Integer);
  if (!answer(kRenderbufferQueries, *renderbuffer, pname, results))
    c->setError(GL_INVALID_ENUM,
                wrongEnum("pname", pname, "Ask for RENDERBUFFER_WIDTH_OES or another of its values"));
}
