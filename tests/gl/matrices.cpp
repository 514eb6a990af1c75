// Section 2.10.2: stacks, products, and how well they hold after very many operations.
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

class Matrices : public GlTest {
 protected:
  const glm::dmat4& modelview() { return state().fixed.modelview; }
  static double distance(const glm::dmat4& a, const glm::dmat4& b) {
    double largest = 0;
    for (int i = 0; i < 16; ++i) {
      largest = std::max(largest, std::abs(glm::value_ptr(a)[i] - glm::value_ptr(b)[i]));
    }
    return largest;
  }
};

}  // namespace

TEST_F(Matrices, StacksAreAsDeepAsTheySay) {
  const struct {
    GLenum mode, limit, depth;
  } stacks[] = {{GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH, GL_MODELVIEW_STACK_DEPTH},
                {GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH},
                {GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH}};
  glActiveTexture(GL_TEXTURE3);
  for (const auto& stack : stacks) {
    glMatrixMode(stack.mode);
    const int limit = integer(stack.limit);
    EXPECT_GE(limit, stack.mode == GL_MODELVIEW ? 32 : stack.mode == GL_PROJECTION ? 4 : 10);
    for (int depth = 1; depth < limit; ++depth) {
      EXPECT_EQ(integer(stack.depth), depth);
      glPushMatrix();
      glTranslatef(1, 0, 0);
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glPushMatrix();
    EXPECT_EQ(glGetError(), GLenum{GL_STACK_OVERFLOW});
    for (int depth = limit; depth > 1; --depth) glPopMatrix();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glPopMatrix();
    EXPECT_EQ(glGetError(), GLenum{GL_STACK_UNDERFLOW});
  }
  EXPECT_EQ(modelview(), glm::dmat4(1.0));
  EXPECT_EQ(state().fixed.projection, glm::dmat4(1.0));
  EXPECT_EQ(state().fixed.units[3].matrix, glm::dmat4(1.0));
}

TEST_F(Matrices, RotationIsRightHandedAndExactAtRightAngles) {
  glRotatef(90, 0, 0, 2);
  EXPECT_EQ(modelview()[0], glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ(modelview()[1], glm::dvec4(-1, 0, 0, 0));
  glRotatef(-450, 0, 0, 1);
  EXPECT_EQ(modelview(), glm::dmat4(1.0));
}

TEST_F(Matrices, RotationAboutTheDiagonalPermutesTheAxes) {
  glRotatef(120, 1, 1, 1);
  const glm::dmat4 cycle(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1);
  EXPECT_LT(distance(modelview(), cycle), 1e-15);
}

TEST_F(Matrices, RotationAboutNoAxisIsTheIdentity) {
  glRotatef(30, 0, 0, 0);
  EXPECT_EQ(modelview(), glm::dmat4(1.0));
}

TEST_F(Matrices, TinyAndHugeAxesKeepTheirDirection) {
  glRotatef(90, 0, 0, std::numeric_limits<float>::denorm_min());
  glRotatef(-90, 0, 0, std::numeric_limits<float>::max());
  EXPECT_EQ(modelview(), glm::dmat4(1.0));
}

TEST_F(Matrices, TranslateAndScaleMultiplyFromTheRight) {
  glScalef(2, 3, 4);
  glTranslatef(1, 1, 1);
  EXPECT_EQ(modelview() * glm::dvec4(0, 0, 0, 1), glm::dvec4(2, 3, 4, 1));
  glLoadIdentity();
  glTranslatex(65536, 0, 0);
  glScalex(2 << 16, 1 << 16, 1 << 16);
  EXPECT_EQ(modelview() * glm::dvec4(1, 0, 0, 1), glm::dvec4(3, 0, 0, 1));
}

TEST_F(Matrices, FrustumMapsNearAndFarCorners) {
  glFrustumf(-1, 3, -2, 1, 0.5f, 8);
  const glm::dvec4 near = modelview() * glm::dvec4(-1, -2, -0.5, 1);
  EXPECT_EQ(near / near.w, glm::dvec4(-1, -1, -1, 1));
  const glm::dvec4 far = modelview() * glm::dvec4(3 * 16, 1 * 16, -8, 1);
  EXPECT_EQ(far / far.w, glm::dvec4(1, 1, 1, 1));
}

TEST_F(Matrices, OrthoMapsItsBox) {
  glOrthof(-4, 4, 8, -8, 2, 6);
  EXPECT_EQ(modelview() * glm::dvec4(-4, 8, -2, 1), glm::dvec4(-1, -1, -1, 1));
  EXPECT_EQ(modelview() * glm::dvec4(4, -8, -6, 1), glm::dvec4(1, 1, 1, 1));
}

TEST_F(Matrices, DepthRangesOfTenOrdersOfMagnitudeKeepTheirEnds) {
  glFrustumf(-1e-3f, 1e-3f, -1e-3f, 1e-3f, 1e-3f, 1e7f);
  const double n = 1e-3f, f = 1e7f;
  const glm::dvec4 near = modelview() * glm::dvec4(0, 0, -n, 1), far = modelview() * glm::dvec4(0, 0, -f, 1);
  EXPECT_NEAR(near.z / near.w, -1, 1e-12);
  EXPECT_NEAR(far.z / far.w, 1, 1e-12);
}

TEST_F(Matrices, AMillionRotationsStayOrthonormal) {
  for (int i = 0; i < 1000000; ++i) glRotatef(0.36f, 0.3f, -0.5f, 0.8f);
  const glm::dmat4& m = modelview();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(glm::dot(m[i], m[j]), i == j ? 1 : 0, 1e-9);
  }
  // All the turns together are one turn about the same axis by a million times the angle.
  const glm::dmat4 sum = m;
  glLoadIdentity();
  glRotatef(static_cast<float>(std::fmod(1e6 * 0.36f, 360.0)), 0.3f, -0.5f, 0.8f);
  EXPECT_LT(distance(sum, m), 1e-4);  // the single angle is a float
}

TEST_F(Matrices, ACameraAMillionUnitsAwayComesBack) {
  for (int i = 0; i < 100000; ++i) {
    glTranslatef(1e6f, -1e6f, 0.125f);
    glTranslatef(-1e6f, 1e6f, -0.125f);
  }
  EXPECT_LT(distance(modelview(), glm::dmat4(1.0)), 1e-9);
}

TEST_F(Matrices, QueryMatrixGivesMantissasAndExponents) {
  const GLfloat m[16] = {1, -0.75f, 1e-20f, 3e20f, 0, 65536, -32768, 1.5f, 2, 3, 4, 5, 6, 7, 8, 9};
  glLoadMatrixf(m);
  GLfixed mantissa[16];
  GLint exponent[16];
  EXPECT_EQ(glQueryMatrixxOES(mantissa, exponent), 0u);
  for (int i = 0; i < 16; ++i) {
    EXPECT_NEAR(std::ldexp(mantissa[i] / 65536.0, exponent[i]), m[i], std::abs(m[i]) * 1e-7) << i;
  }
}

TEST_F(Matrices, QueryMatrixTellsWhatIsNotANumber) {
  GLfloat m[16] = {};
  m[3] = std::numeric_limits<float>::infinity();
  m[15] = std::numeric_limits<float>::quiet_NaN();
  glLoadMatrixf(m);
  GLfixed mantissa[16];
  GLint exponent[16];
  EXPECT_EQ(glQueryMatrixxOES(mantissa, exponent), (1u << 3) | (1u << 15));
}

TEST_F(Matrices, GetsRoundOnce) {
  const GLfloat m[16] = {0.1f, -0.2f, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 40000};
  glLoadMatrixf(m);
  GLfloat floats[16];
  glGetFloatv(GL_MODELVIEW_MATRIX, floats);
  EXPECT_EQ(floats[0], 0.1f);
  GLint bits[16];
  glGetIntegerv(GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES, bits);
  EXPECT_EQ(std::memcmp(bits, m, sizeof m), 0);
  GLfixed fixed[16];
  glGetFixedv(GL_MODELVIEW_MATRIX, fixed);
  EXPECT_EQ(fixed[2], 3 << 16);
  EXPECT_EQ(fixed[1], -13107);  // -0.2 * 65536 = -13107.2
  EXPECT_EQ(fixed[15], std::numeric_limits<GLfixed>::max());
}

TEST_F(Matrices, MarksOnlyItsGroupAndOnlyChanges) {
  changed() = 0;
  glLoadIdentity();
  EXPECT_EQ(changed(), 0u);
  glTranslatef(1, 0, 0);
  EXPECT_EQ(changed(), gen::Groups{gen::kGroupModelview});
  changed() = 0;
  glPushMatrix();
  glPopMatrix();
  EXPECT_EQ(changed(), 0u);
  glMatrixMode(GL_TEXTURE);
  glScalef(2, 1, 1);
  EXPECT_EQ(changed(), gen::Groups{gen::kGroupTextureMatrix});
}

}  // namespace anteroom::gl::test
