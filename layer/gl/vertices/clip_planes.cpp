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
template <class T>
void setPlane(GLenum name, const T* equation, double (*number)(T),
              const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  gen::ClipPlane* plane = planeOf(*c, name);
  if (!plane) return c->setError(GL_INVALID_ENUM, wrongPlane(name), command);
  if (!equation) return;
  const glm::dvec4 object(number(equation[0]), number(equation[1]), number(equation[2]), number(equation[3]));
  glm::dvec4 eye = object * glm::inverse(c->state.fixed.modelview);
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
  Results(equation, form).put(Results::Kind::Number, plane->equation);
}

}  // namespace

GL_API void GL_APIENTRY glClipPlanef(GLenum plane, const GLfloat* equation) {
  setPlane<GLfloat>(plane, equation, [](GLfloat value) -> double { return value; });
}

GL_API void GL_APIENTRY glClipPlanex(GLenum plane, const GLfixed* equation) {
  setPlane<GLfixed>(plane, equation, fixedToDouble);
}

GL_API void GL_APIENTRY glGetClipPlanef(GLenum name, GLfloat* equation) {
  getPlane(name, equation, Results::Form::Float);
}

GL_API void GL_APIENTRY glGetClipPlanex(GLenum name, GLfixed* equation) {
  getPlane(name, equation, Results::Form::Fixed);
}
