// Section 2.7: current color, normal and texture coordinates. None of them is clamped.
#include "layer/gl/context/params.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

void setColor(float r, float g, float b, float a) {
  Context* c = current();
  if (!c) return;
  c->set(c->state.fixed.attributes[gen::kColor].current, {r, g, b, a}, gen::kGroupCurrentColor);
}

void setNormal(float x, float y, float z) {
  Context* c = current();
  if (!c) return;
  c->set(c->state.fixed.attributes[gen::kNormal].current, {x, y, z, 1}, gen::kGroupCurrentOther);
}

void setTexCoord(GLenum texture, float s, float t, float r, float q,
                 const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  const int unit = unitOf(*c, "target", texture, command);
  if (unit < 0) return;
  c->set(c->state.fixed.attributes[gen::texCoord(unit)].current, {s, t, r, q}, gen::kGroupCurrentOther);
}

}  // namespace

GL_API void GL_APIENTRY glColor4f(GLfloat r, GLfloat g, GLfloat b, GLfloat a) {
  setColor(r, g, b, a);
}
GL_API void GL_APIENTRY glColor4ub(GLubyte r, GLubyte g, GLubyte b, GLubyte a) {
  constexpr auto scaled = [](GLubyte v) { return static_cast<float>(v) / 255.0f; };
  setColor(scaled(r), scaled(g), scaled(b), scaled(a));
}
GL_API void GL_APIENTRY glColor4x(GLfixed r, GLfixed g, GLfixed b, GLfixed a) {
  setColor(fromFixed(r), fromFixed(g), fromFixed(b), fromFixed(a));
}

GL_API void GL_APIENTRY glNormal3f(GLfloat x, GLfloat y, GLfloat z) {
  setNormal(x, y, z);
}
GL_API void GL_APIENTRY glNormal3x(GLfixed x, GLfixed y, GLfixed z) {
  setNormal(fromFixed(x), fromFixed(y), fromFixed(z));
}

GL_API void GL_APIENTRY glMultiTexCoord4f(GLenum texture, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
  setTexCoord(texture, s, t, r, q);
}
GL_API void GL_APIENTRY glMultiTexCoord4x(GLenum texture, GLfixed s, GLfixed t, GLfixed r, GLfixed q) {
  setTexCoord(texture, fromFixed(s), fromFixed(t), fromFixed(r), fromFixed(q));
}
