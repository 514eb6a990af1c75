// Sections 3.2.1 and 4.1.3: multisample buffers and the state that modifies coverage.
#include "harness.h"

namespace conformance {
namespace {

class Multisampling : public GlTest {};

constexpr Vec4 kBlack = {0, 0, 0, 0};

void setColor(const Vec4& c) {
  glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
            static_cast<GLfloat>(c[3]));
}

void clearTo(const Vec4& c) {
  glClearColor(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
               static_cast<GLfloat>(c[3]));
  glClear(GL_COLOR_BUFFER_BIT);
}

// 4.1.3: without a multisample buffer the multisample state has no effect.
TEST_F(Multisampling, MultisampleStateWithoutSamples) {
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  glEnable(GL_SAMPLE_COVERAGE);
  glSampleCoverage(0, GL_FALSE);
  setColor({0, 1, 0, 0.2});
  drawRect();
  EXPECT_PIXEL(32, 32, {0, 1, 0, 0.2});
}

class MultisamplingOnSamples : public GlTest {
 protected:
  MultisamplingOnSamples() : GlTest({64, 64, 8, 8, 8, 8, 24, 8, 4}) {}
  void SetUp() override {
    MESA_DISAGREES("3.2.1", "a pbuffer of a config with samples has one sample a pixel");
    GlTest::SetUp();
  }
};

// 4.1.3: coverage masks a part of the samples, and the resolved colour follows.
TEST_F(MultisamplingOnSamples, SampleCoverage) {
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  ASSERT_EQ(samples, 4);
  glEnable(GL_SAMPLE_COVERAGE);
  setColor({1, 1, 1, 1});
  for (bool invert : {false, true}) {
    for (double value : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      clearTo(kBlack);
      glSampleCoverage(static_cast<GLfloat>(value), invert);
      drawRect();
      const double expected = invert ? 1 - value : value;
      EXPECT_PIXEL(32, 32, {expected, expected, expected, expected}) << value << " invert " << invert;
    }
  }
}

// 4.1.3: alpha to coverage grows with alpha and is exact at the ends; alpha to one follows.
TEST_F(MultisamplingOnSamples, AlphaToCoverage) {
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  double last = -1;
  for (double alpha : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    clearTo(kBlack);
    setColor({1, 1, 1, alpha});
    drawRect();
    const Vec4 pixel = readPixel(32, 32);
    EXPECT_GE(pixel[0], last);
    EXPECT_NEAR(pixel[0], alpha, 0.26) << alpha;
    last = pixel[0];
  }
  EXPECT_PIXEL(32, 32, {1, 1, 1, 1});
  clearTo(kBlack);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  setColor({1, 0, 0, 0.25});
  drawRect();
  EXPECT_PIXEL(32, 32, {1, 0, 0, 1});
}

// 3.5.3: an edge through a pixel is resolved from its samples; inside and outside stay exact.
TEST_F(MultisamplingOnSamples, Edges) {
  setColor({1, 1, 1, 1});
  const GLfloat triangle[] = {-1, -1, 1, -1, -1, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, triangle);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_PIXEL(10, 10, {1, 1, 1, 1});
  EXPECT_PIXEL(50, 50, kBlack);
  const double edge = readPixel(31, 32)[0];
  EXPECT_GT(edge, 0.2);
  EXPECT_LT(edge, 0.8);
}

// (3.2), 3.10: a multisampled point smaller than the threshold is drawn at the threshold's size, its alpha
// faded by the square of the ratio.
TEST_F(MultisamplingOnSamples, PointFade) {
  glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 8);
  glPointSize(4);
  setColor({1, 0, 0, 1});
  const GLfloat position[] = {0, 0};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, position);
  glDrawArrays(GL_POINTS, 0, 1);
  EXPECT_PIXEL(32, 32, {1, 0, 0, 0.25});
  clearTo(kBlack);
  glPointSize(12);
  glDrawArrays(GL_POINTS, 0, 1);
  EXPECT_PIXEL(32, 32, {1, 0, 0, 1});
}

// 3.5.3: depth and stencil are kept for each sample; a picture of two layers resolves to the upper one.
TEST_F(MultisamplingOnSamples, DepthAndStencil) {
  glEnable(GL_DEPTH_TEST);
  setColor({0, 1, 0, 1});
  const GLfloat triangle[] = {-1, -1, -0.5f, 1, -1, -0.5f, -1, 1, -0.5f};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, triangle);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  setColor({1, 0, 0, 1});
  const GLfloat behind[] = {-1, -1, 0.5f, 1, -1, 0.5f, -1, 1, 0.5f, 1, 1, 0.5f};
  glVertexPointer(3, GL_FLOAT, 0, behind);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(10, 10, {0, 1, 0, 1});
  EXPECT_PIXEL(50, 50, {1, 0, 0, 1});
  // The samples of the edge are shared out, none is lost or counted twice.
  const Vec4 edge = readPixel(31, 32);
  EXPECT_NEAR(edge[0] + edge[1], 1, 1.5 / 255);
  EXPECT_GT(edge[0], 0.2);
  EXPECT_GT(edge[1], 0.2);
}

}  // namespace
}  // namespace conformance
