// Section 2.10.2: the matrix stacks, and OES_matrix_palette. Everything is float64; a matrix is rounded when
// a shader or a query reads it.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "layer/gl/context/context.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

gen::Groups groupOf(GLenum mode) {
  if (mode == GL_MODELVIEW) return gen::kGroupModelview;
  if (mode == GL_PROJECTION) return gen::kGroupProjection;
  return mode == GL_TEXTURE ? gen::kGroupTextureMatrix : gen::kGroupPalette;
}

glm::dmat4& currentMatrix(Context& c) {
  if (c.matrixMode == GL_MODELVIEW) return c.state.fixed.modelview;
  if (c.matrixMode == GL_PROJECTION) return c.state.fixed.projection;
  if (c.matrixMode == GL_MATRIX_PALETTE_OES)
    return c.palette.matrices[static_cast<size_t>(c.currentPaletteMatrix)];
  return c.state.fixed.units[c.activeTexture].matrix;
}

void load(Context& c, const glm::dmat4& matrix) {
  c.set(currentMatrix(c), matrix, groupOf(c.matrixMode));
}

void multiply(Context& c, const glm::dmat4& matrix) {
  glm::dmat4& top = currentMatrix(c);
  top = top * matrix;
  c.mark(groupOf(c.matrixMode));
}

template <class T>
glm::dmat4 matrixOf(const T* m, double scale) {
  glm::dmat4 result;
  for (int i = 0; i < 16; ++i) glm::value_ptr(result)[i] = m[i] * scale;
  return result;
}
constexpr double kFixedScale = 1.0 / 65536.0;

void translate(double x, double y, double z) {
  Context* c = current();
  if (!c) return;
  glm::dmat4& m = currentMatrix(*c);
  m[3] = m[0] * x + m[1] * y + m[2] * z + m[3];
  c->mark(groupOf(c->matrixMode));
}

void scale(double x, double y, double z) {
  Context* c = current();
  if (!c) return;
  glm::dmat4& m = currentMatrix(*c);
  m[0] *= x;
  m[1] *= y;
  m[2] *= z;
  c->mark(groupOf(c->matrixMode));
}

// Sine and cosine of an angle in degrees, exact at multiples of 90.
void sineCosine(double degrees, double& sine, double& cosine) {
  int quadrant = 0;
  const double remainder = std::remquo(degrees, 90.0, &quadrant);
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const double s = std::sin(remainder * kRadians), c = std::cos(remainder * kRadians);
  switch (quadrant & 3) {
    case 0:
      sine = s, cosine = c;
      break;
    case 1:
      sine = c, cosine = -s;
      break;
    case 2:
      sine = -s, cosine = -c;
      break;
    default:
      sine = -c, cosine = s;
      break;
  }
}

// About an axis without direction nothing turns.
void rotate(double angle, double x, double y, double z) {
  Context* c = current();
  if (!c) return;
  const glm::dvec3 axis(x, y, z);
  const double length = glm::length(axis);
  if (length == 0) return;
  const glm::dvec3 u = axis / length;
  double s = 0, k = 1;
  sineCosine(angle, s, k);
  const glm::dvec3 v = u * (1 - k);
  glm::dmat4 r(1.0);
  r[0] = {u.x * v.x + k, u.y * v.x + u.z * s, u.z * v.x - u.y * s, 0};
  r[1] = {u.x * v.y - u.z * s, u.y * v.y + k, u.z * v.y + u.x * s, 0};
  r[2] = {u.x * v.z + u.y * s, u.y * v.z - u.x * s, u.z * v.z + k, 0};
  multiply(*c, r);
}

Fault noPaletteStack() {
  return wrongState("Matrices of the palette have no stack", "Set another matrix mode before");
}

Fault emptyVolume() {
  return wrongState("Two opposite planes are the same",
                    "Give a left other than right, a bottom other than top, a near other than far");
}

void frustum(double l, double r, double b, double t, double n, double f,
             const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (!(n > 0) || !(f > 0))
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber(n > 0 ? "far" : "near", n > 0 ? f : n, "Give a distance above 0"),
                       command);
  if (l == r || b == t || n == f) return c->setError(GL_INVALID_VALUE, emptyVolume(), command);
  glm::dmat4 m(0.0);
  m[0][0] = 2 * n / (r - l);
  m[1][1] = 2 * n / (t - b);
  m[2] = {(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1};
  m[3][2] = -2 * f * n / (f - n);
  multiply(*c, m);
}

void ortho(double l, double r, double b, double t, double n, double f,
           const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (l == r || b == t || n == f) return c->setError(GL_INVALID_VALUE, emptyVolume(), command);
  glm::dmat4 m(1.0);
  m[0][0] = 2 / (r - l);
  m[1][1] = 2 / (t - b);
  m[2][2] = -2 / (f - n);
  m[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1};
  multiply(*c, m);
}

template <int Depth>
void push(Context& c, MatrixStack<Depth>& stack) {
  if (stack.depth == Depth)
    return c.setError(
        GL_STACK_OVERFLOW,
        wrongNumber("the depth of the stack", Depth, "Call glPopMatrix as often as glPushMatrix"),
        "glPushMatrix");
  stack.below[stack.depth++ - 1] = currentMatrix(c);
}

template <int Depth>
void pop(Context& c, MatrixStack<Depth>& stack) {
  if (stack.depth == 1)
    return c.setError(GL_STACK_UNDERFLOW,
                      wrongState("Nothing was pushed", "Call glPushMatrix as often as glPopMatrix"),
                      "glPopMatrix");
  load(c, stack.below[--stack.depth - 1]);
}

}  // namespace

GL_API void GL_APIENTRY glMatrixMode(GLenum mode) {
  Context* c = current();
  if (!c) return;
  if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE && mode != GL_MATRIX_PALETTE_OES)
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("mode", mode, "Use MODELVIEW, PROJECTION, TEXTURE or MATRIX_PALETTE_OES"));
  c->matrixMode = mode;
}

GL_API void GL_APIENTRY glLoadIdentity(void) {
  if (Context* c = current()) load(*c, glm::dmat4(1.0));
}

GL_API void GL_APIENTRY glLoadMatrixf(const GLfloat* m) {
  Context* c = current();
  if (c && m) load(*c, matrixOf(m, 1.0));
}

GL_API void GL_APIENTRY glLoadMatrixx(const GLfixed* m) {
  Context* c = current();
  if (c && m) load(*c, matrixOf(m, kFixedScale));
}

GL_API void GL_APIENTRY glMultMatrixf(const GLfloat* m) {
  Context* c = current();
  if (c && m) multiply(*c, matrixOf(m, 1.0));
}

GL_API void GL_APIENTRY glMultMatrixx(const GLfixed* m) {
  Context* c = current();
  if (c && m) multiply(*c, matrixOf(m, kFixedScale));
}

GL_API void GL_APIENTRY glTranslatef(GLfloat x, GLfloat y, GLfloat z) {
  translate(x, y, z);
}
GL_API void GL_APIENTRY glTranslatex(GLfixed x, GLfixed y, GLfixed z) {
  translate(fixedToDouble(x), fixedToDouble(y), fixedToDouble(z));
}

GL_API void GL_APIENTRY glScalef(GLfloat x, GLfloat y, GLfloat z) {
  scale(x, y, z);
}
GL_API void GL_APIENTRY glScalex(GLfixed x, GLfixed y, GLfixed z) {
  scale(fixedToDouble(x), fixedToDouble(y), fixedToDouble(z));
}

GL_API void GL_APIENTRY glRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
  rotate(angle, x, y, z);
}
GL_API void GL_APIENTRY glRotatex(GLfixed angle, GLfixed x, GLfixed y, GLfixed z) {
  rotate(fixedToDouble(angle), fixedToDouble(x), fixedToDouble(y), fixedToDouble(z));
}

GL_API void GL_APIENTRY glFrustumf(GLfloat l, GLfloat r, GLfloat b, GLfloat t, GLfloat n, GLfloat f) {
  frustum(l, r, b, t, n, f);
}
GL_API void GL_APIENTRY glFrustumx(GLfixed l, GLfixed r, GLfixed b, GLfixed t, GLfixed n, GLfixed f) {
  frustum(fixedToDouble(l), fixedToDouble(r), fixedToDouble(b), fixedToDouble(t), fixedToDouble(n),
          fixedToDouble(f));
}

GL_API void GL_APIENTRY glOrthof(GLfloat l, GLfloat r, GLfloat b, GLfloat t, GLfloat n, GLfloat f) {
  ortho(l, r, b, t, n, f);
}
GL_API void GL_APIENTRY glOrthox(GLfixed l, GLfixed r, GLfixed b, GLfixed t, GLfixed n, GLfixed f) {
  ortho(fixedToDouble(l), fixedToDouble(r), fixedToDouble(b), fixedToDouble(t), fixedToDouble(n),
        fixedToDouble(f));
}

GL_API void GL_APIENTRY glPushMatrix(void) {
  Context* c = current();
  if (!c) return;
  if (c->matrixMode == GL_MODELVIEW) return push(*c, c->modelviewStack);
  if (c->matrixMode == GL_PROJECTION) return push(*c, c->projectionStack);
  if (c->matrixMode == GL_MATRIX_PALETTE_OES) return c->setError(GL_STACK_OVERFLOW, noPaletteStack());
  push(*c, c->textureStacks[c->activeTexture]);
}

GL_API void GL_APIENTRY glPopMatrix(void) {
  Context* c = current();
  if (!c) return;
  if (c->matrixMode == GL_MODELVIEW) return pop(*c, c->modelviewStack);
  if (c->matrixMode == GL_PROJECTION) return pop(*c, c->projectionStack);
  if (c->matrixMode == GL_MATRIX_PALETTE_OES) return c->setError(GL_STACK_UNDERFLOW, noPaletteStack());
  pop(*c, c->textureStacks[c->activeTexture]);
}

GL_API void GL_APIENTRY glCurrentPaletteMatrixOES(GLuint index) {
  Context* c = current();
  if (!c) return;
  if (index >= gen::kPaletteMatrices)
    return c->setError(
        GL_INVALID_VALUE,
        wrongNumber("index", index, "Give an index below the value of MAX_PALETTE_MATRICES_OES"));
  c->currentPaletteMatrix = static_cast<int>(index);
}

GL_API void GL_APIENTRY glLoadPaletteFromModelViewMatrixOES(void) {
  Context* c = current();
  if (!c) return;
  glm::dmat4& matrix = c->palette.matrices[static_cast<size_t>(c->currentPaletteMatrix)];
  c->set(matrix, c->state.fixed.modelview, gen::kGroupPalette);
}

// OES_query_matrix: element i is mantissa[i] / 65536 * 2^exponent[i].
GL_API GLbitfield GL_APIENTRY glQueryMatrixxOES(GLfixed* mantissa, GLint* exponent) {
  Context* c = current();
  if (!c || !mantissa || !exponent) return 0;
  const double* m = glm::value_ptr(currentMatrix(*c));
  GLbitfield invalid = 0;
  for (int i = 0; i < 16; ++i) {
    int power = 0;
    const bool valid = std::isfinite(m[i]);
    const double fraction = valid ? std::frexp(m[i], &power) : 0;
    if (!valid) invalid |= 1u << i;
    // |fraction| is in [1/2, 1): 2^30 of it uses every bit of a mantissa.
    mantissa[i] = toFixed(std::ldexp(fraction, 14));
    exponent[i] = fraction == 0 ? 0 : power - 14;
  }
  return invalid;
}
