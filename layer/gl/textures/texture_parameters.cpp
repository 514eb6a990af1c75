// TexParameter and its queries (sections 3.7.5, 6.1.3).
#include "gen/ati.h"
#include "layer/gl/context/forms.h"
#include "layer/gl/queries/query.h"
#include "layer/gl/textures/texture.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;
namespace render = anteroom::render;

namespace {

bool isMinFilter(TextureSlot slot, GLenum value) {
  if (value == GL_NEAREST || value == GL_LINEAR) return true;
  return slot != kSlotExternal && (value >= GL_NEAREST_MIPMAP_NEAREST && value <= GL_LINEAR_MIPMAP_LINEAR);
}
bool isMagFilter(GLenum value) {
  return value == GL_NEAREST || value == GL_LINEAR;
}
bool isWrapMode(TextureSlot slot, GLenum value) {
  if (value == GL_CLAMP_TO_EDGE) return true;
  return slot != kSlotExternal &&
         (value == GL_REPEAT || value == GL_MIRRORED_REPEAT_OES || value == gen::kMirrorClamp ||
          value == gen::kMirrorClampToEdge || value == gen::kMirrorClampToBorder);
}

constexpr const char* kLegalValues = "Use a value of table 3.10 that goes with pname and target";
constexpr const char* kNames =
    "Use TEXTURE_MIN_FILTER, TEXTURE_MAG_FILTER, TEXTURE_WRAP_S, TEXTURE_WRAP_T, TEXTURE_WRAP_R_OES, "
    "GENERATE_MIPMAP, TEXTURE_MAX_ANISOTROPY_EXT, TEXTURE_MAX_LEVEL_APPLE, or TEXTURE_CROP_RECT_OES with a "
    "command that takes a pointer";

using enum Results::Kind;

// Table 6.14, OES_draw_texture, OES_texture_3D, OES_EGL_image_external, EXT_texture_filter_anisotropic,
// EXT_texture_storage, APPLE_texture_max_level. Booleans are not scaled in fixed point, like the values that
// set them.
constexpr auto kTextureQueries = tableOf<Query<Texture>>({
    {GL_TEXTURE_MIN_FILTER, Enum, [](Texture& t) { return t.sampler.minFilter; }},
    {GL_TEXTURE_MAG_FILTER, Enum, [](Texture& t) { return t.sampler.magFilter; }},
    {GL_TEXTURE_WRAP_S, Enum, [](Texture& t) { return t.sampler.wrapS; }},
    {GL_TEXTURE_WRAP_T, Enum, [](Texture& t) { return t.sampler.wrapT; }},
    {GL_GENERATE_MIPMAP, Enum, [](Texture& t) { return t.generateMipmap; }},
    {GL_TEXTURE_CROP_RECT_OES, Integer, [](Texture& t) { return t.cropRect; }},
    {GL_TEXTURE_WRAP_R_OES, Enum, [](Texture& t) { return t.sampler.wrapR; }},
    {GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, Integer, [](Texture&) { return 1; }},
    {GL_TEXTURE_MAX_ANISOTROPY_EXT, Number, [](Texture& t) { return t.sampler.maxAnisotropy; }},
    {GL_TEXTURE_IMMUTABLE_FORMAT_EXT, Enum, [](Texture& t) { return t.immutable(); }},
    {GL_TEXTURE_MAX_LEVEL_APPLE, Integer, [](Texture& t) { return t.sampler.maxLevel; }},
});

// What can be asked for and not set.
bool isReadOnly(GLenum pname) {
  return pname == GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES || pname == GL_TEXTURE_IMMUTABLE_FORMAT_EXT;
}

template <class T>
void assign(Context& c, Texture& texture, T& field, T value, bool legal, const char* command,
            GLenum error = GL_INVALID_ENUM) {
  if (!legal) return c.setError(error, wrongEnum("param", static_cast<GLenum>(value), kLegalValues), command);
  if (field == value) return;
  field = value;
  texture.changed(c);
}

void setParameter(GLenum target, GLenum pname, const Params& params,
                  const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const TextureSlot slot = slotForCommand(*c, target, command);
  if (slot == kSlotCount) return;
  if (!kTextureQueries.find(pname) || isReadOnly(pname))
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kNames), command);
  if (params.null()) return;
  ShareLock lock(*c->group);
  Texture& texture = boundTexture(*c, slot);
  render::Sampler& sampler = texture.sampler;
  const GLenum value = params.enumerant();
  switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
      return assign(*c, texture, sampler.minFilter, value, isMinFilter(slot, value), command);
    case GL_TEXTURE_MAG_FILTER:
      return assign(*c, texture, sampler.magFilter, value, isMagFilter(value), command);
    case GL_TEXTURE_WRAP_S:
      return assign(*c, texture, sampler.wrapS, value, isWrapMode(slot, value), command);
    case GL_TEXTURE_WRAP_T:
      return assign(*c, texture, sampler.wrapT, value, isWrapMode(slot, value), command);
    case GL_TEXTURE_WRAP_R_OES:
      return assign(*c, texture, sampler.wrapR, value, isWrapMode(slot, value), command);
    case GL_GENERATE_MIPMAP:
      if (slot == kSlotExternal && params.boolean())
        return c->setError(GL_INVALID_ENUM,
                           wrongEnum("pname", pname, "Textures of EGLImages alone have one level"), command);
      texture.generateMipmap = params.boolean();
      return;
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
      return assign(*c, texture, sampler.maxAnisotropy, params.number(), params.number() >= 1, command,
                    GL_INVALID_VALUE);
    case GL_TEXTURE_MAX_LEVEL_APPLE: {
      const int level = roundToInt(params.number());
      return assign(*c, texture, sampler.maxLevel, level, level >= 0, command, GL_INVALID_VALUE);
    }
    default:  // GL_TEXTURE_CROP_RECT_OES
      if (!params.vector()) return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kNames), command);
      for (size_t i = 0; i < texture.cropRect.size(); ++i)
        texture.cropRect[i] = params.rounded(static_cast<int>(i));
  }
}

void getParameter(GLenum target, GLenum pname, Results results, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const TextureSlot slot = slotForCommand(*c, target, command);
  if (slot == kSlotCount) return;
  ShareLock lock(*c->group);
  if (!answer(kTextureQueries, boundTexture(*c, slot), pname, results))
    c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kNames), command);
}

}  // namespace

ANTEROOM_SETTERS(glTexParameter, , (GLenum target, GLenum pname), setParameter(target, pname, params))
ANTEROOM_INTEGER_SETTERS(glTexParameter, , (GLenum target, GLenum pname), setParameter(target, pname, params))
ANTEROOM_GETTERS(glGetTexParameter, , (GLenum target, GLenum pname), getParameter(target, pname, results))
ANTEROOM_INTEGER_GETTER(glGetTexParameter, , (GLenum target, GLenum pname),
                        getParameter(target, pname, results))
