#include "tests/reference/texture_environment.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "gen/ati.h"

namespace anteroom::reference {

namespace {

using Samples = std::array<glm::dvec4, gen::kMaxTextureUnits>;

glm::dvec4 clamp01(const glm::dvec4& c) {
  return glm::clamp(c, glm::dvec4(0), glm::dvec4(1));
}

struct Inputs {
  const render::State& state;
  Samples samples;  // as this unit sees them: what was routed to a unit in place of its texture
  size_t unit;
  glm::dvec4 primary, previous;
  double fogFactor;
};

// Tables 3.18 and 3.19, OES_texture_env_crossbar, ATI_texture_env_combine3 and gen/ati.h.
glm::dvec4 source(const Inputs& in, GLenum name) {
  switch (name) {
    case GL_TEXTURE:
      return in.samples[in.unit];
    case GL_CONSTANT:
      return clamp01(in.state.fixed.units[in.unit].env.color);
    case GL_PRIMARY_COLOR:
      return in.primary;
    case GL_PREVIOUS:
      return in.previous;
    case GL_ZERO:
    case gen::kSecondaryColor:
      return glm::dvec4(0);
    case GL_ONE:
      return glm::dvec4(1);
    case GL_FOG:
      return glm::dvec4(in.fogFactor);
    default:
      return in.samples[std::min<size_t>(name - GL_TEXTURE0, gen::kMaxTextureUnits - 1)];
  }
}

glm::dvec3 rgbArgument(const Inputs& in, GLenum name, GLenum operand) {
  const glm::dvec4 color = source(in, name);
  switch (operand) {
    case GL_SRC_COLOR:
      return color;
    case GL_ONE_MINUS_SRC_COLOR:
      return 1.0 - glm::dvec3(color);
    case GL_SRC_ALPHA:
      return glm::dvec3(color.a);
    default:
      return glm::dvec3(1 - color.a);
  }
}
double alphaArgument(const Inputs& in, GLenum name, GLenum operand) {
  const double alpha = source(in, name).a;
  return operand == GL_ONE_MINUS_SRC_ALPHA ? 1 - alpha : alpha;
}

// Table 3.17 and ATI_texture_env_combine3, for colors and for alphas.
template <typename T>
T combine(GLenum function, const T& a0, const T& a1, const T& a2) {
  switch (function) {
    case GL_REPLACE:
      return a0;
    case GL_MODULATE:
      return a0 * a1;
    case GL_ADD:
      return a0 + a1;
    case GL_ADD_SIGNED:
      return a0 + a1 - 0.5;
    case GL_INTERPOLATE:
      return a0 * a2 + a1 * (1.0 - a2);
    case gen::kModulateAdd:
      return a0 * a2 + a1;
    case gen::kModulateSignedAdd:
      return a0 * a2 + a1 - 0.5;
    case gen::kModulateSubtract:
      return a0 * a2 - a1;
    default:
      return a0 - a1;  // GL_SUBTRACT
  }
}

glm::dvec4 combiner(const Inputs& in) {
  const gen::TextureEnv& env = in.state.fixed.units[in.unit].env;
  glm::dvec3 c[3];
  double a[3];
  for (size_t i = 0; i < 3; ++i) {
    c[i] = rgbArgument(in, env.srcRgb[i], env.operandRgb[i]);
    a[i] = alphaArgument(in, env.srcAlpha[i], env.operandAlpha[i]);
  }
  const double rgbScale = env.rgbScale, alphaScale = env.alphaScale;
  if (env.combineRgb == gen::kDot3RgbExt || env.combineRgb == gen::kDot3RgbaExt) {
    const double dot = 4 * glm::dot(c[0] - 0.5, c[1] - 0.5);
    const double alpha = combine(env.combineAlpha, a[0], a[1], a[2]) * alphaScale;
    return clamp01({glm::dvec3(dot), env.combineRgb == gen::kDot3RgbaExt ? dot : alpha});
  }
  if (env.combineRgb == GL_DOT3_RGB || env.combineRgb == GL_DOT3_RGBA) {
    const double dot = 4 * glm::dot(c[0] - 0.5, c[1] - 0.5);
    const double alpha = env.combineRgb == GL_DOT3_RGBA ? dot : combine(env.combineAlpha, a[0], a[1], a[2]);
    return clamp01({glm::dvec3(dot * rgbScale), alpha * alphaScale});
  }
  return clamp01({combine(env.combineRgb, c[0], c[1], c[2]) * rgbScale,
                  combine(env.combineAlpha, a[0], a[1], a[2]) * alphaScale});
}

size_t argumentCount(GLenum function) {
  if (function == GL_REPLACE) return 1;
  const bool three = function == GL_INTERPOLATE || function == gen::kModulateAdd ||
                     function == gen::kModulateSignedAdd || function == gen::kModulateSubtract;
  return three ? 3 : 2;
}

// ATIX_texture_env_route, as gen/ati.h has it: the units whose texture an earlier unit's result stands for.
struct Routes {
  std::array<bool, gen::kMaxTextureUnits> rgb{}, alpha{};
};

bool readsAlpha(GLenum operand) {
  return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
}

// OES_texture_env_crossbar: a unit that combines the texture of a unit that is off is off itself.
bool readsUnitThatIsOff(const render::State& state, const gen::TextureEnv& env, const Routes& routes) {
  if (env.mode != GL_COMBINE) return false;
  const auto off = [&](GLenum source, GLenum operand) {
    const GLenum unit = source - GL_TEXTURE0;
    return unit < gen::kMaxTextureUnits && state.fixed.units[unit].target == gen::TextureTarget::None &&
           !(readsAlpha(operand) ? routes.alpha : routes.rgb)[unit];
  };
  for (size_t i = 0; i < argumentCount(env.combineRgb); ++i) {
    if (off(env.srcRgb[i], env.operandRgb[i])) return true;
  }
  if (env.combineRgb == GL_DOT3_RGBA || env.combineRgb == gen::kDot3RgbaExt) return false;
  for (size_t i = 0; i < argumentCount(env.combineAlpha); ++i) {
    if (off(env.srcAlpha[i], env.operandAlpha[i])) return true;
  }
  return false;
}

// IMG_texture_env_enhanced_fixed_function, Table 3.24, entry by entry.
glm::dvec4 enhancedFunction(GLenum mode, GLenum format, const glm::dvec4& f, const glm::dvec4& s,
                            double factorAlpha) {
  const glm::dvec3 cf(f), cs(s);
  const bool hasAlpha = format != GL_LUMINANCE && format != GL_RGB;
  const bool onlyAlpha = format == GL_ALPHA;
  switch (mode) {
    case GL_MODULATE_COLOR_IMG:
      return {onlyAlpha ? cf : cf * cs, hasAlpha ? s.a : f.a};
    case GL_RECIP_ADD_SIGNED_ALPHA_IMG:
      return {cf, hasAlpha ? 1 - s.a + f.a - 0.5 : f.a - 0.5};
    case GL_TEXTURE_ALPHA_MODULATE_IMG:
      if (onlyAlpha) return {0, 0, 0, s.a};
      return hasAlpha ? glm::dvec4(s.a * cs, s.a) : glm::dvec4(cs, 1);
    case GL_FACTOR_ALPHA_MODULATE_IMG:
      return {onlyAlpha ? glm::dvec3(0) : factorAlpha * cs, factorAlpha};
    case GL_FRAGMENT_ALPHA_MODULATE_IMG:
      return {onlyAlpha ? glm::dvec3(0) : f.a * cs, f.a};
    case GL_ADD_BLEND_IMG:
      return {onlyAlpha ? cf : cf + (1 - f.a) * cs, hasAlpha ? f.a * s.a : f.a};
    default:  // GL_DOT3_RGBA_IMG
      if (format != GL_RGB && format != GL_RGBA) return f;
      return glm::dvec4(4 * glm::dot(cf - 0.5, cs - 0.5));
  }
}

// Tables 3.15 and 3.16.
glm::dvec4 textureFunction(const Inputs& in) {
  const gen::TextureUnit& unit = in.state.fixed.units[in.unit];
  const glm::dvec4 f = in.previous, t = in.samples[in.unit];
  const glm::dvec3 cf(f), ct(t), cc(clamp01(unit.env.color));
  const bool hasColor = unit.baseFormat != GL_ALPHA;
  const bool hasAlpha = unit.baseFormat != GL_LUMINANCE && unit.baseFormat != GL_RGB;
  const double modulatedAlpha = hasAlpha ? f.a * t.a : f.a;
  switch (unit.env.mode) {
    case GL_REPLACE:
      return {hasColor ? ct : cf, hasAlpha ? t.a : f.a};
    case GL_MODULATE:
      return {hasColor ? cf * ct : cf, modulatedAlpha};
    case GL_DECAL:  // defined for RGB and RGBA; elsewhere the fragment passes
      if (unit.baseFormat == GL_RGB) return {ct, f.a};
      if (unit.baseFormat == GL_RGBA) return {cf * (1 - t.a) + ct * t.a, f.a};
      return f;
    case GL_BLEND:
      return {hasColor ? cf * (1.0 - ct) + cc * ct : cf, modulatedAlpha};
    case GL_ADD:
      return {hasColor ? cf + ct : cf, modulatedAlpha};
    case GL_COMBINE:
      return combiner(in);
    default:
      return enhancedFunction(unit.env.mode, unit.baseFormat, f, t, clamp01(unit.env.color).a);
  }
}

// Puts the unit's result in the place of the texture that it is routed to.
void route(const gen::TextureEnv& env, const glm::dvec4& result, Samples& samples, Routes& routes) {
  if (env.outputRgb >= 0) {
    const size_t to = static_cast<size_t>(env.outputRgb);
    samples[to] = {glm::dvec3(result), samples[to].a};
    routes.rgb[to] = true;
  }
  if (env.outputAlpha >= 0) {
    const size_t to = static_cast<size_t>(env.outputAlpha);
    samples[to].a = result.a;
    routes.alpha[to] = true;
  }
}

}  // namespace

glm::dvec4 applyTextures(const render::State& state, const glm::dvec4& primary, const Samples& samples,
                         double fogFactor) {
  glm::dvec4 color = clamp01(primary);
  Samples routed = samples;
  Routes routes;
  for (size_t unit = 0; unit < gen::kMaxTextureUnits; ++unit) {
    if (state.fixed.units[unit].target == gen::TextureTarget::None) continue;
    const gen::TextureEnv& env = state.fixed.units[unit].env;
    if (!readsUnitThatIsOff(state, env, routes)) {
      const Samples& seen = env.mode == GL_COMBINE ? routed : samples;
      color = clamp01(textureFunction({state, seen, unit, clamp01(primary), color, fogFactor}));
    }
    route(env, color, routed, routes);
  }
  return color;
}

}  // namespace anteroom::reference
