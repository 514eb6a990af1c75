// Sections 3.7.12 and 3.3: texture environments and point sprite coordinates; the active unit (2.10.2); and
// texture coordinate generation (OES_texture_cube_map).
#include "layer/gl/params.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

constexpr gen::Groups kTextures = gen::kGroupTextures;

// Where an environment parameter that is an enum is kept; null: `pname` is none of them.
GLenum* enumOf(gen::TextureEnv& env, GLenum pname) {
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      return &env.mode;
    case GL_COMBINE_RGB:
      return &env.combineRgb;
    case GL_COMBINE_ALPHA:
      return &env.combineAlpha;
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
      return &env.srcRgb[pname - GL_SRC0_RGB];
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      return &env.srcAlpha[pname - GL_SRC0_ALPHA];
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
      return &env.operandRgb[pname - GL_OPERAND0_RGB];
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
      return &env.operandAlpha[pname - GL_OPERAND0_ALPHA];
    default:
      return nullptr;
  }
}

bool isAlphaCombiner(GLenum value) {
  switch (value) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_ADD:
    case GL_ADD_SIGNED:
    case GL_INTERPOLATE:
    case GL_SUBTRACT:
      return true;
    default:
      return false;
  }
}

// Tables 3.15 to 3.19.
bool isLegal(GLenum pname, GLenum value) {
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      return value == GL_REPLACE || value == GL_MODULATE || value == GL_DECAL || value == GL_BLEND ||
             value == GL_ADD || value == GL_COMBINE;
    case GL_COMBINE_RGB:
      return isAlphaCombiner(value) || value == GL_DOT3_RGB || value == GL_DOT3_RGBA;
    case GL_COMBINE_ALPHA:
      return isAlphaCombiner(value);
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      return value == GL_TEXTURE || value == GL_CONSTANT || value == GL_PRIMARY_COLOR ||
             value == GL_PREVIOUS || value - GL_TEXTURE0 < gen::kMaxTextureUnits;
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
      return value >= GL_SRC_COLOR && value <= GL_ONE_MINUS_SRC_ALPHA;
    default:
      return value == GL_SRC_ALPHA || value == GL_ONE_MINUS_SRC_ALPHA;
  }
}

gen::TextureUnit& activeUnit(Context& c) {
  return c.state.fixed.units[c.activeTexture];
}

void setScale(Context& c, float& field, float value) {
  if (value != 1 && value != 2 && value != 4) return c.setError(GL_INVALID_VALUE);
  c.set(field, value, kTextures);
}

void setEnv(GLenum target, GLenum pname, const Params& params) {
  Context* c = current();
  if (!c || params.null()) return;
  gen::TextureEnv& env = activeUnit(*c).env;
  if (target == GL_POINT_SPRITE_OES) {
    if (pname != GL_COORD_REPLACE_OES) return c->setError(GL_INVALID_ENUM);
    return c->set(env.coordReplace, params.boolean(), kTextures | gen::kGroupPoints);
  }
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) {
    if (pname != GL_TEXTURE_LOD_BIAS_EXT) return c->setError(GL_INVALID_ENUM);
    return c->set(env.lodBias, params.number(), kTextures);
  }
  if (target != GL_TEXTURE_ENV) return c->setError(GL_INVALID_ENUM);
  switch (pname) {
    case GL_TEXTURE_ENV_COLOR:
      if (!params.vector()) return c->setError(GL_INVALID_ENUM);
      return c->set(env.color, clamp01(params.color()), kTextures);
    case GL_RGB_SCALE:
      return setScale(*c, env.rgbScale, params.number());
    case GL_ALPHA_SCALE:
      return setScale(*c, env.alphaScale, params.number());
    default:
      break;
  }
  GLenum* field = enumOf(env, pname);
  if (!field || !isLegal(pname, params.enumerant())) return c->setError(GL_INVALID_ENUM);
  c->set(*field, params.enumerant(), kTextures);
}

void getEnv(GLenum target, GLenum pname, Results results) {
  Context* c = current();
  if (!c) return;
  gen::TextureEnv& env = activeUnit(*c).env;
  if (target == GL_POINT_SPRITE_OES && pname == GL_COORD_REPLACE_OES)
    return results.boolean(env.coordReplace);
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT && pname == GL_TEXTURE_LOD_BIAS_EXT)
    return results.number(env.lodBias);
  if (target != GL_TEXTURE_ENV) return c->setError(GL_INVALID_ENUM);
  switch (pname) {
    case GL_TEXTURE_ENV_COLOR:
      return results.normaliseds(env.color);
    case GL_RGB_SCALE:
      return results.number(env.rgbScale);
    case GL_ALPHA_SCALE:
      return results.number(env.alphaScale);
    default:
      break;
  }
  const GLenum* field = enumOf(env, pname);
  if (!field) return c->setError(GL_INVALID_ENUM);
  results.enumerant(*field);
}

void setTexGen(GLenum coord, GLenum pname, const Params& params) {
  Context* c = current();
  if (!c || params.null()) return;
  if (coord != GL_TEXTURE_GEN_STR_OES || pname != GL_TEXTURE_GEN_MODE_OES)
    return c->setError(GL_INVALID_ENUM);
  const GLenum mode = params.enumerant();
  if (mode != GL_NORMAL_MAP_OES && mode != GL_REFLECTION_MAP_OES) return c->setError(GL_INVALID_ENUM);
  c->set(activeUnit(*c).texGenMode, mode, kTextures);
}

void getTexGen(GLenum coord, GLenum pname, Results results) {
  Context* c = current();
  if (!c) return;
  if (coord != GL_TEXTURE_GEN_STR_OES || pname != GL_TEXTURE_GEN_MODE_OES)
    return c->setError(GL_INVALID_ENUM);
  results.enumerant(activeUnit(*c).texGenMode);
}

}  // namespace

GL_API void GL_APIENTRY glActiveTexture(GLenum texture) {
  Context* c = current();
  if (!c) return;
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit >= gen::kMaxTextureUnits) return c->setError(GL_INVALID_ENUM);
  c->activeTexture = static_cast<int>(unit);
}

GL_API void GL_APIENTRY glTexEnvf(GLenum target, GLenum pname, GLfloat param) {
  setEnv(target, pname, Params::floats(&param, false));
}
GL_API void GL_APIENTRY glTexEnvfv(GLenum target, GLenum pname, const GLfloat* params) {
  setEnv(target, pname, Params::floats(params, true));
}
GL_API void GL_APIENTRY glTexEnvi(GLenum target, GLenum pname, GLint param) {
  setEnv(target, pname, Params::integers(&param, false));
}
GL_API void GL_APIENTRY glTexEnviv(GLenum target, GLenum pname, const GLint* params) {
  setEnv(target, pname, Params::integers(params, true));
}
GL_API void GL_APIENTRY glTexEnvx(GLenum target, GLenum pname, GLfixed param) {
  setEnv(target, pname, Params::fixeds(&param, false));
}
GL_API void GL_APIENTRY glTexEnvxv(GLenum target, GLenum pname, const GLfixed* params) {
  setEnv(target, pname, Params::fixeds(params, true));
}

GL_API void GL_APIENTRY glGetTexEnvfv(GLenum target, GLenum pname, GLfloat* params) {
  if (params) getEnv(target, pname, {params, Results::Form::Float});
}
GL_API void GL_APIENTRY glGetTexEnviv(GLenum target, GLenum pname, GLint* params) {
  if (params) getEnv(target, pname, {params, Results::Form::Integer});
}
GL_API void GL_APIENTRY glGetTexEnvxv(GLenum target, GLenum pname, GLfixed* params) {
  if (params) getEnv(target, pname, {params, Results::Form::Fixed});
}

GL_API void GL_APIENTRY glTexGenfOES(GLenum coord, GLenum pname, GLfloat param) {
  setTexGen(coord, pname, Params::floats(&param, false));
}
GL_API void GL_APIENTRY glTexGenfvOES(GLenum coord, GLenum pname, const GLfloat* params) {
  setTexGen(coord, pname, Params::floats(params, true));
}
GL_API void GL_APIENTRY glTexGeniOES(GLenum coord, GLenum pname, GLint param) {
  setTexGen(coord, pname, Params::integers(&param, false));
}
GL_API void GL_APIENTRY glTexGenivOES(GLenum coord, GLenum pname, const GLint* params) {
  setTexGen(coord, pname, Params::integers(params, true));
}
GL_API void GL_APIENTRY glTexGenxOES(GLenum coord, GLenum pname, GLfixed param) {
  setTexGen(coord, pname, Params::fixeds(&param, false));
}
GL_API void GL_APIENTRY glTexGenxvOES(GLenum coord, GLenum pname, const GLfixed* params) {
  setTexGen(coord, pname, Params::fixeds(params, true));
}
GL_API void GL_APIENTRY glGetTexGenfvOES(GLenum coord, GLenum pname, GLfloat* params) {
  if (params) getTexGen(coord, pname, {params, Results::Form::Float});
}
GL_API void GL_APIENTRY glGetTexGenivOES(GLenum coord, GLenum pname, GLint* params) {
  if (params) getTexGen(coord, pname, {params, Results::Form::Integer});
}
GL_API void GL_APIENTRY glGetTexGenxvOES(GLenum coord, GLenum pname, GLfixed* params) {
  if (params) getTexGen(coord, pname, {params, Results::Form::Fixed});
}
