// EXT_polygon_offset_clamp: depths of offset polygons, found by the depth test against known ones.
#include <algorithm>
#include <cmath>
#include <limits>

#include "extension_commands.h"

namespace conformance {
namespace {

constexpr GLenum kClampName = 0x8E1B;  // POLYGON_OFFSET_CLAMP_EXT
using PolygonOffsetClampProc = void(GL_APIENTRY*)(GLfloat factor, GLfloat units, GLfloat clamp);

class PolygonOffsetClamp : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_EXT_polygon_offset_clamp");
    polygonOffsetClamp_ = command<PolygonOffsetClampProc>("glPolygonOffsetClampEXT");
    ASSERT_NE(polygonOffsetClamp_, nullptr);
  }

  static GLfloat clamp() {
    GLfloat value = -1;
    glGetFloatv(kClampName, &value);
    return value;
  }

  // The window depth at the middle of a quad whose depth rises by `slope` a pixel to the right, offset as
  // set.
  double offsetDepth(double slope) const {
    const auto rise = static_cast<GLfloat>(slope * width());  // in normalised coordinates over half the width
    const GLfloat quad[] = {-1, -1, -rise, 1, -1, rise, -1, 1, -rise, 1, 1, rise};
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, quad);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_POLYGON_OFFSET_FILL);
    // The depth that was stored lies between the last depth that passes LESS and the next.
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    double low = 0, high = 1;
    for (int step = 0; step < 14; ++step) {
      const double middle = (low + high) / 2;
      glColor4f(0, 0, 0, 1);
      glDisable(GL_DEPTH_TEST);
      drawRect();
      glEnable(GL_DEPTH_TEST);
      glColor4f(1, 1, 1, 1);
      drawRect({-1, -1, 1, 1, middle * 2 - 1});
      (readPixel(32, 32)[0] > 0.5 ? low : high) = middle;
    }
    glDepthMask(GL_TRUE);
    return low;
  }

  PolygonOffsetClampProc polygonOffsetClamp_ = nullptr;
};

TEST_F(PolygonOffsetClamp, State) {
  EXPECT_EQ(clamp(), 0);
  polygonOffsetClamp_(2, 3, -0.25f);
  EXPECT_EQ(clamp(), -0.25f);
  GLfloat value = 0;
  glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &value);
  EXPECT_EQ(value, 2);
  glGetFloatv(GL_POLYGON_OFFSET_UNITS, &value);
  EXPECT_EQ(value, 3);
  GLint integer = -1;
  polygonOffsetClamp_(2, 3, 7);
  glGetIntegerv(kClampName, &integer);
  EXPECT_EQ(integer, 7);
  GLfixed fixed = 0;
  glGetFixedv(kClampName, &fixed);
  EXPECT_EQ(fixed, 7 * 65536);
  GLboolean truth = GL_FALSE;
  glGetBooleanv(kClampName, &truth);
  EXPECT_EQ(truth, GL_TRUE);
  // PolygonOffset is the same with a clamp of 0.
  glPolygonOffset(1, 1);
  EXPECT_EQ(clamp(), 0);
  polygonOffsetClamp_(1, 1, 1);
  glPolygonOffsetx(65536, 65536);
  EXPECT_EQ(clamp(), 0);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// o = m * factor, cut at the clamp from above or from below.
TEST_F(PolygonOffsetClamp, Offsets) {
  const double slope = 1 / 512.0, infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    double factor, clamp, offset;
  } rows[] = {{64, 0, 64 * slope},          {64, 0.05, 0.05},
              {64, 0.5, 64 * slope},        {64, -0.05, 64 * slope},
              {-64, 0, -64 * slope},        {-64, -0.05, -0.05},
              {-64, -0.5, -64 * slope},     {-64, 0.05, -64 * slope},
              {64, infinity, 64 * slope},   {64, nan, 64 * slope},
              {-64, -infinity, -64 * slope}};
  // The pixel's center lies half a pixel right of the middle.
  const double plain = 0.5 + slope / 2;
  for (const auto& row : rows) {
    polygonOffsetClamp_(static_cast<GLfloat>(row.factor), 0, static_cast<GLfloat>(row.clamp));
    EXPECT_NEAR(offsetDepth(slope), plain + row.offset, 2e-4)
        << "factor " << row.factor << " clamp " << row.clamp;
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// A polygon seen nearly edge on: the offset would be larger than the whole range.
TEST_F(PolygonOffsetClamp, SteepPolygons) {
  polygonOffsetClamp_(1e6f, 0, 0.125f);
  EXPECT_NEAR(offsetDepth(1 / 128.0), 0.5 + 0.125 + 0.5 / 128, 2e-4);
  polygonOffsetClamp_(-1e6f, 0, -0.125f);
  EXPECT_NEAR(offsetDepth(1 / 128.0), 0.5 - 0.125 + 0.5 / 128, 2e-4);
  // Units are part of the sum that is cut.
  polygonOffsetClamp_(0, 1e9f, 0.25f);
  EXPECT_NEAR(offsetDepth(0), 0.75, 2e-4);
}

}  // namespace
}  // namespace conformance
