// Section 2.12: lights, material, light model, shading, and their queries (6.1.3).
#include <glm/mat3x3.hpp>

#include "layer/gl/context/forms.h"
#include "layer/gl/queries/query.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

constexpr gen::Groups kLighting = gen::kGroupLighting;

gen::Light* lightOf(Context& c, GLenum light) {
  const GLenum index = light - GL_LIGHT0;
  return index < gen::kMaxLights ? &c.state.fixed.lighting.lights[index] : nullptr;
}

constexpr const char* kLights = "Use LIGHT0 to LIGHT7";
constexpr const char* kLightNames =
    "Use AMBIENT, DIFFUSE, SPECULAR, POSITION, SPOT_DIRECTION, SPOT_EXPONENT, SPOT_CUTOFF, "
    "CONSTANT_ATTENUATION, LINEAR_ATTENUATION or QUADRATIC_ATTENUATION";
constexpr const char* kMaterialNames =
    "Use AMBIENT, DIFFUSE, SPECULAR, EMISSION or SHININESS; to set both, AMBIENT_AND_DIFFUSE";
constexpr const char* kVectors = "It has several values: use the command that takes a pointer";

using enum Results::Kind;

// Table 6.10
constexpr auto kLightQueries = tableOf<Query<gen::Light>>({
    {GL_AMBIENT, Normalised, [](gen::Light& light) { return light.ambient; }},
    {GL_DIFFUSE, Normalised, [](gen::Light& light) { return light.diffuse; }},
    {GL_SPECULAR, Normalised, [](gen::Light& light) { return light.specular; }},
    {GL_POSITION, Number, [](gen::Light& light) { return light.position; }},
    {GL_SPOT_DIRECTION, Number, [](gen::Light& light) { return light.spotDirection; }},
    {GL_SPOT_EXPONENT, Number, [](gen::Light& light) { return light.spotExponent; }},
    {GL_SPOT_CUTOFF, Number, [](gen::Light& light) { return light.spotCutoff; }},
    {GL_CONSTANT_ATTENUATION, Number, [](gen::Light& light) { return light.attenuation.x; }},
    {GL_LINEAR_ATTENUATION, Number, [](gen::Light& light) { return light.attenuation.y; }},
    {GL_QUADRATIC_ATTENUATION, Number, [](gen::Light& light) { return light.attenuation.z; }},
});

// What ambient and diffuse are while they follow the current color.
glm::vec4 tracked(const Context& c, const glm::vec4& field) {
  return c.state.fixed.lighting.colorMaterial ? c.state.fixed.attributes[gen::kColor].current : field;
}

// Table 6.9
constexpr auto kMaterialQueries = tableOf<Query<Context>>({
    {GL_AMBIENT, Normalised, [](Context& c) { return tracked(c, c.state.fixed.lighting.material.ambient); }},
    {GL_DIFFUSE, Normalised, [](Context& c) { return tracked(c, c.state.fixed.lighting.material.diffuse); }},
    {GL_SPECULAR, Normalised, [](Context& c) { return c.state.fixed.lighting.material.specular; }},
    {GL_EMISSION, Normalised, [](Context& c) { return c.state.fixed.lighting.material.emission; }},
    {GL_SHININESS, Number, [](Context& c) { return c.state.fixed.lighting.material.shininess; }},
});

bool inRange(float value, float low, float high) {
  return value >= low && value <= high;
}

void setAttenuation(Context& c, float& field, float value, const char* command) {
  if (!(value >= 0))
    return c.setError(GL_INVALID_VALUE, wrongNumber("param", value, "Give an attenuation from 0 on"),
                      command);
  c.set(field, value, kLighting);
}

void setLightVector(Context& c, gen::Light& light, GLenum pname, const Params& params) {
  const glm::dmat4& modelview = c.state.fixed.modelview;
  switch (pname) {
    case GL_AMBIENT:
      return c.set(light.ambient, params.vec4(), kLighting);
    case GL_DIFFUSE:
      return c.set(light.diffuse, params.vec4(), kLighting);
    case GL_SPECULAR:
      return c.set(light.specular, params.vec4(), kLighting);
    case GL_POSITION:
      return c.set(light.position, modelview * glm::dvec4(params.vec4()), kLighting);
    default:  // GL_SPOT_DIRECTION
      return c.set(light.spotDirection, glm::dmat3(modelview) * glm::dvec3(params.vec3()), kLighting);
  }
}

void setLight(GLenum name, GLenum pname, const Params& params, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  gen::Light* light = lightOf(*c, name);
  if (!light) return c->setError(GL_INVALID_ENUM, wrongEnum("light", name, kLights), command);
  if (!kLightQueries.find(pname))
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kLightNames), command);
  if (params.null()) return;
  switch (pname) {
    case GL_SPOT_EXPONENT:
      if (!inRange(params.number(), 0, 128))
        return c->setError(GL_INVALID_VALUE,
                           wrongNumber("param", params.number(), "Give an exponent from 0 to 128"), command);
      return c->set(light->spotExponent, params.number(), kLighting);
    case GL_SPOT_CUTOFF:
      if (!inRange(params.number(), 0, 90) && params.number() != 180)
        return c->setError(
            GL_INVALID_VALUE,
            wrongNumber("param", params.number(), "Give an angle from 0 to 90 degrees, or 180"), command);
      return c->set(light->spotCutoff, params.number(), kLighting);
    case GL_CONSTANT_ATTENUATION:
      return setAttenuation(*c, light->attenuation.x, params.number(), command);
    case GL_LINEAR_ATTENUATION:
      return setAttenuation(*c, light->attenuation.y, params.number(), command);
    case GL_QUADRATIC_ATTENUATION:
      return setAttenuation(*c, light->attenuation.z, params.number(), command);
    default:
      if (!params.vector()) return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kVectors), command);
      return setLightVector(*c, *light, pname, params);
  }
}

// Ambient and diffuse cannot be set while they follow the current color (section 2.12.3).
void setTracked(Context& c, glm::vec4& field, const glm::vec4& value) {
  if (!c.state.fixed.lighting.colorMaterial) c.set(field, value, kLighting);
}

void setMaterial(GLenum face, GLenum pname, const Params& params,
                 const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (face != GL_FRONT_AND_BACK)
    return c->setError(GL_INVALID_ENUM, wrongEnum("face", face, "Use FRONT_AND_BACK"), command);
  if (pname != GL_AMBIENT_AND_DIFFUSE && !kMaterialQueries.find(pname))
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kMaterialNames), command);
  if (params.null()) return;
  gen::Material& material = c->state.fixed.lighting.material;
  if (pname == GL_SHININESS) {
    if (!inRange(params.number(), 0, 128))
      return c->setError(GL_INVALID_VALUE,
                         wrongNumber("param", params.number(), "Give a shininess from 0 to 128"), command);
    return c->set(material.shininess, params.number(), kLighting);
  }
  if (!params.vector()) return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kVectors), command);
  switch (pname) {
    case GL_AMBIENT:
      return setTracked(*c, material.ambient, params.vec4());
    case GL_DIFFUSE:
      return setTracked(*c, material.diffuse, params.vec4());
    case GL_AMBIENT_AND_DIFFUSE:
      setTracked(*c, material.ambient, params.vec4());
      return setTracked(*c, material.diffuse, params.vec4());
    case GL_SPECULAR:
      return c->set(material.specular, params.vec4(), kLighting);
    default:  // GL_EMISSION
      return c->set(material.emission, params.vec4(), kLighting);
  }
}

void setLightModel(GLenum pname, const Params& params, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (pname != GL_LIGHT_MODEL_TWO_SIDE && (pname != GL_LIGHT_MODEL_AMBIENT || !params.vector()))
    return c->setError(
        GL_INVALID_ENUM,
        wrongEnum("pname", pname,
                  "Use LIGHT_MODEL_TWO_SIDE, or LIGHT_MODEL_AMBIENT with a command that takes a pointer"),
        command);
  if (params.null()) return;
  if (pname == GL_LIGHT_MODEL_TWO_SIDE)
    return c->set(c->state.fixed.lighting.twoSided, params.boolean(), kLighting);
  c->set(c->state.fixed.lighting.modelAmbient, params.vec4(), kLighting);
}

void getLight(GLenum name, GLenum pname, Results results, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  gen::Light* light = lightOf(*c, name);
  if (!light) return c->setError(GL_INVALID_ENUM, wrongEnum("light", name, kLights), command);
  if (!answer(kLightQueries, *light, pname, results))
    c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kLightNames), command);
}

void getMaterial(GLenum face, GLenum pname, Results results, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (face != GL_FRONT && face != GL_BACK)
    return c->setError(GL_INVALID_ENUM, wrongEnum("face", face, "Use FRONT or BACK"), command);
  if (!answer(kMaterialQueries, *c, pname, results))
    c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kMaterialNames), command);
}

}  // namespace

ANTEROOM_SETTERS(glLight, , (GLenum light, GLenum pname), setLight(light, pname, params))
ANTEROOM_GETTERS(glGetLight, , (GLenum light, GLenum pname), getLight(light, pname, results))

ANTEROOM_SETTERS(glMaterial, , (GLenum face, GLenum pname), setMaterial(face, pname, params))
ANTEROOM_GETTERS(glGetMaterial, , (GLenum face, GLenum pname), getMaterial(face, pname, results))

ANTEROOM_SETTERS(glLightModel, , (GLenum pname), setLightModel(pname, params))

GL_API void GL_APIENTRY glShadeModel(GLenum mode) {
  Context* c = current();
  if (!c) return;
  if (mode != GL_FLAT && mode != GL_SMOOTH)
    return c->setError(GL_INVALID_ENUM, wrongEnum("mode", mode, "Use FLAT or SMOOTH"));
  c->set(c->state.fixed.shadeModel, mode, kLighting);
}
