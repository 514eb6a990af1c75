// Section 2.11: user clip planes, kept in eye coordinates.
#include <cmath>
#include <glm/matrix.hpp>

#include "layer/gl/context/params.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

gen::ClipPlane* planeOf(Context& c, GLenum plane) {
  const GLenum index = plane - GL_CLIP_PLANE0;
  return index < gen::kMaxClipPlanes ? &c.state.fixed.clipPlanes[index] : nullptr;
}

Fault wrongPlane(GLenum name) {
  return wrongEnum("plane", name, "Use CLIP_PLANE0 and the next, up to the value of MAX_CLIP_PLANES");
}

// Multiplied by the inverse of the modelview matrix. A singular one leaves no plane: everything is inside.
void setPlane(GLenum name, const glm::dvec4& equation, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  gen::ClipPlane* plane = planeOf(*c, name);
  if (!plane) return c->setError(GL_INVALID_ENUM, wrongPlane(name), command);
  glm::dvec4 eye = equation * glm::inverse(c->state.fixed.modelview);
  for (int i = 0; i < 4; ++i) {
    if (!std::isfinite(eye[i])) eye = glm::dvec4(0.0);
  }
  c->set(plane->equation, eye, gen::kGroupClipPlanes);
}

void getPlane(GLenum name, void* equation, Results::Form form, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const gen::ClipPlane* plane = planeOf(*c, name);
  if (!plane) return c->setError(GL_INVALID_ENUM, wrongPlane(name), command);
  if (equation) Results(equation, form).put(Results::Kind::Number, plane->equation);
}

}  // namespace

GL_API void GL_APIENTRY glClipPlanef(GLenum plane, const GLfloat* equation) {
  if (equation) setPlane(plane, {equation[0], equation[1], equation[2], equation[3]});
}

GL_API void GL_APIENTRY glClipPlanex(GLenum plane, const GLfixed* equation) {
  if (!equation) return;
  setPlane(plane, {fixedToDouble(equation[0]), fixedToDouble(equation[1]), fixedToDouble(equation[2]),
                   fixedToDouble(equation[3])});
}

GL_API void GL_APIENTRY glGetClipPlanef(GLenum name, GLfloat* equation) {
  getPlane(name, equation, Results::Form::Float);
}

GL_API void GL_APIENTRY glGetClipPlanex(GLenum name, GLfixed* equation) {
  getPlane(name, equation, Results::Form::Fixed);
}
