// Sections 3.7.12 and 3.3: texture environments and point sprite coordinates; the active unit (2.10.2); and
// texture coordinate generation (OES_texture_cube_map).
#include "gen/ati.h"
#include "layer/gl/context/forms.h"
#include "layer/gl/queries/query.h"

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
    case gen::kModulateAdd:
    case gen::kModulateSignedAdd:
    case gen::kModulateSubtract:
      return true;
    default:
      return false;
  }
}

bool isMode(GLenum value) {
  switch (value) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_DECAL:
    case GL_BLEND:
    case GL_ADD:
    case GL_COMBINE:
    case GL_MODULATE_COLOR_IMG:
    case GL_RECIP_ADD_SIGNED_ALPHA_IMG:
    case GL_TEXTURE_ALPHA_MODULATE_IMG:
    case GL_FACTOR_ALPHA_MODULATE_IMG:
    case GL_FRAGMENT_ALPHA_MODULATE_IMG:
    case GL_ADD_BLEND_IMG:
    case GL_DOT3_RGBA_IMG:
      return true;
    default:
      return false;
  }
}

bool isSource(GLenum value) {
  switch (value) {
    case GL_TEXTURE:
    case GL_CONSTANT:
    case GL_PRIMARY_COLOR:
    case GL_PREVIOUS:
    case GL_ZERO:
    case GL_ONE:
      return true;
    default:
      return value - GL_TEXTURE0 < gen::kMaxTextureUnits;
  }
}

// Tables 3.15 to 3.19, ATI_texture_env_combine3, EXT_texture_env_dot3, ATIX_texture_env_route and
// IMG_texture_env_enhanced_fixed_function.
bool isLegal(GLenum pname, GLenum value) {
  switch (pname) {
    case GL_TEXTURE_ENV_MODE:
      return isMode(value);
    case GL_COMBINE_RGB:
      return isAlphaCombiner(value) || value == GL_DOT3_RGB || value == GL_DOT3_RGBA ||
             value == gen::kDot3RgbExt || value == gen::kDot3RgbaExt;
    case GL_COMBINE_ALPHA:
      return isAlphaCombiner(value);
    case GL_SRC0_RGB:
    case GL_SRC1_RGB:
    case GL_SRC2_RGB:
      return isSource(value) || value == gen::kSecondaryColor;
    case GL_SRC0_ALPHA:
    case GL_SRC1_ALPHA:
    case GL_SRC2_ALPHA:
      return isSource(value) || value == GL_FOG;
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

constexpr const char* kEnvTargets = "Use TEXTURE_ENV, POINT_SPRITE_OES or TEXTURE_FILTER_CONTROL_EXT";
constexpr const char* kEnvNames =
    "Use TEXTURE_ENV_MODE, TEXTURE_ENV_COLOR, COMBINE_RGB, COMBINE_ALPHA, SRC0_RGB to SRC2_RGB, SRC0_ALPHA "
    "to "
    "SRC2_ALPHA, OPERAND0_RGB to OPERAND2_RGB, OPERAND0_ALPHA to OPERAND2_ALPHA, RGB_SCALE or ALPHA_SCALE";

void setScale(Context& c, float& field, float value, const char* command) {
  if (value != 1 && value != 2 && value != 4)
    return c.setError(GL_INVALID_VALUE, wrongNumber("param", value, "Use a scale of 1, 2 or 4"), command);
  c.set(field, value, kTextures);
}

// ATIX_texture_env_route; a unit's own texture stands for none.
void setOutput(Context& c, int8_t& field, GLenum texture, const char* command) {
  const int unit = unitOf(c, "param", texture, command);
  if (unit < 0) return;
  c.set(field, static_cast<int8_t>(unit == c.activeTexture ? -1 : unit), kTextures);
}
GLenum output(const Context& c, int8_t field) {
  return GL_TEXTURE0 + static_cast<GLenum>(field < 0 ? c.activeTexture : field);
}

using enum Results::Kind;

// Table 6.15 but for its enums (enumOf), and ATIX_texture_env_route.
constexpr auto kEnvQueries = tableOf<Query<Context>>({
    {GL_TEXTURE_ENV_COLOR, Normalised, [](Context& c) { return activeUnit(c).env.color; }},
    {GL_RGB_SCALE, Number, [](Context& c) { return activeUnit(c).env.rgbScale; }},
    {GL_ALPHA_SCALE, Number, [](Context& c) { return activeUnit(c).env.alphaScale; }},
    {gen::kTextureOutputRgb, Enum, [](Context& c) { return output(c, activeUnit(c).env.outputRgb); }},
    {gen::kTextureOutputAlpha, Enum, [](Context& c) { return output(c, activeUnit(c).env.outputAlpha); }},
});

// Whether an environment has what is asked for or set; if not, the error is set.
bool isEnvName(Context& c, GLenum target, GLenum pname, const char* command) {
  const char* names = nullptr;
  bool known = false;
  if (target == GL_POINT_SPRITE_OES) {
    known = pname == GL_COORD_REPLACE_OES;
    names = "Use COORD_REPLACE_OES";
  } else if (target == GL_TEXTURE_FILTER_CONTROL_EXT) {
    known = pname == GL_TEXTURE_LOD_BIAS_EXT;
    names = "Use TEXTURE_LOD_BIAS_EXT";
  } else if (target == GL_TEXTURE_ENV) {
    known = enumOf(activeUnit(c).env, pname) || kEnvQueries.find(pname);
    names = kEnvNames;
  } else {
    c.setError(GL_INVALID_ENUM, wrongEnum("target", target, kEnvTargets), command);
    return false;
  }
  if (!known) c.setError(GL_INVALID_ENUM, wrongEnum("pname", pname, names), command);
  return known;
}

void setEnv(GLenum target, GLenum pname, const Params& params, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c || !isEnvName(*c, target, pname, command) || params.null()) return;
  gen::TextureEnv& env = activeUnit(*c).env;
  if (target == GL_POINT_SPRITE_OES)
    return c->set(env.coordReplace, params.boolean(), kTextures | gen::kGroupPoints);
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) return c->set(env.lodBias, params.number(), kTextures);
  switch (pname) {
    case GL_TEXTURE_ENV_COLOR:
      if (!params.vector())
        return c->setError(
            GL_INVALID_ENUM,
            wrongEnum("pname", pname, "It has four values: use a command that takes a pointer"), command);
      return c->set(env.color, clamp01(params.color()), kTextures);
    case GL_RGB_SCALE:
      return setScale(*c, env.rgbScale, params.number(), command);
    case GL_ALPHA_SCALE:
      return setScale(*c, env.alphaScale, params.number(), command);
    case gen::kTextureOutputRgb:
      return setOutput(*c, env.outputRgb, params.enumerant(), command);
    case gen::kTextureOutputAlpha:
      return setOutput(*c, env.outputAlpha, params.enumerant(), command);
    default:
      break;
  }
  if (!isLegal(pname, params.enumerant()))
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum("param", params.enumerant(), "Use a value of table 3.14 that goes with pname"), command);
  c->set(*enumOf(env, pname), params.enumerant(), kTextures);
}

void getEnv(GLenum target, GLenum pname, Results results, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c || !isEnvName(*c, target, pname, command)) return;
  gen::TextureEnv& env = activeUnit(*c).env;
  if (target == GL_POINT_SPRITE_OES) return results.put(Boolean, env.coordReplace);
  if (target == GL_TEXTURE_FILTER_CONTROL_EXT) return results.put(Number, env.lodBias);
  if (const GLenum* field = enumOf(env, pname)) return results.put(Enum, *field);
  answer(kEnvQueries, *c, pname, results);
}

Fault wrongTexGen(GLenum coord, GLenum pname) {
  const bool ofCoord = coord != GL_TEXTURE_GEN_STR_OES;
  return wrongEnum(ofCoord ? "coord" : "pname", ofCoord ? coord : pname,
                   "Use TEXTURE_GEN_STR_OES and TEXTURE_GEN_MODE_OES");
}

void setTexGen(GLenum coord, GLenum pname, const Params& params, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (coord != GL_TEXTURE_GEN_STR_OES || pname != GL_TEXTURE_GEN_MODE_OES)
    return c->setError(GL_INVALID_ENUM, wrongTexGen(coord, pname), command);
  if (params.null()) return;
  const GLenum mode = params.enumerant();
  if (mode != GL_NORMAL_MAP_OES && mode != GL_REFLECTION_MAP_OES)
    return c->setError(GL_INVALID_ENUM, wrongEnum("param", mode, "Use NORMAL_MAP_OES or REFLECTION_MAP_OES"),
                       command);
  c->set(activeUnit(*c).texGenMode, mode, kTextures);
}

void getTexGen(GLenum coord, GLenum pname, Results results, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (coord != GL_TEXTURE_GEN_STR_OES || pname != GL_TEXTURE_GEN_MODE_OES)
    return c->setError(GL_INVALID_ENUM, wrongTexGen(coord, pname), command);
  results.put(Enum, activeUnit(*c).texGenMode);
}

}  // namespace

GL_API void GL_APIENTRY glActiveTexture(GLenum texture) {
  Context* c = current();
  if (!c) return;
  const int unit = unitOf(*c, "texture", texture);
  if (unit >= 0) c->activeTexture = unit;
}

ANTEROOM_SETTERS(glTexEnv, , (GLenum target, GLenum pname), setEnv(target, pname, params))
ANTEROOM_INTEGER_SETTERS(glTexEnv, , (GLenum target, GLenum pname), setEnv(target, pname, params))
ANTEROOM_GETTERS(glGetTexEnv, , (GLenum target, GLenum pname), getEnv(target, pname, results))
ANTEROOM_INTEGER_GETTER(glGetTexEnv, , (GLenum target, GLenum pname), getEnv(target, pname, results))

ANTEROOM_SETTERS(glTexGen, OES, (GLenum coord, GLenum pname), setTexGen(coord, pname, params))
ANTEROOM_INTEGER_SETTERS(glTexGen, OES, (GLenum coord, GLenum pname), setTexGen(coord, pname, params))
ANTEROOM_GETTERS(glGetTexGen, OES, (GLenum coord, GLenum pname), getTexGen(coord, pname, results))
ANTEROOM_INTEGER_GETTER(glGetTexGen, OES, (GLenum coord, GLenum pname), getTexGen(coord, pname, results))
