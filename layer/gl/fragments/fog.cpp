// Section 3.8: fog.
#include "layer/gl/context/forms.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

constexpr const char* kNames = "Use FOG_MODE, FOG_DENSITY, FOG_START, FOG_END or FOG_COLOR";

void setFog(GLenum pname, const Params& params, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (pname < GL_FOG_DENSITY || pname > GL_FOG_COLOR)
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kNames), command);
  if (params.null()) return;
  gen::Fog& fog = c->state.fixed.fog;
  switch (pname) {
    case GL_FOG_MODE: {
      const GLenum mode = params.enumerant();
      if (mode != GL_EXP && mode != GL_EXP2 && mode != GL_LINEAR)
        return c->setError(GL_INVALID_ENUM, wrongEnum("param", mode, "Use EXP, EXP2 or LINEAR"), command);
      return c->set(fog.mode, mode, gen::kGroupFog);
    }
    case GL_FOG_DENSITY:
      if (!(params.number() >= 0))
        return c->setError(GL_INVALID_VALUE,
                           wrongNumber("param", params.number(), "Give a density from 0 on"), command);
      return c->set(fog.density, params.number(), gen::kGroupFog);
    case GL_FOG_START:
      return c->set(fog.start, params.number(), gen::kGroupFog);
    case GL_FOG_END:
      return c->set(fog.end, params.number(), gen::kGroupFog);
    default:  // GL_FOG_COLOR
      if (!params.vector())
        return c->setError(
            GL_INVALID_ENUM,
            wrongEnum("pname", pname, "FOG_COLOR has four values: use a command that takes a pointer"),
            command);
      return c->set(fog.color, clamp01(params.color()), gen::kGroupFog);
  }
}

}  // namespace

ANTEROOM_SETTERS(glFog, , (GLenum pname), setFog(pname, params))
