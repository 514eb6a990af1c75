// Numbers, pointers and sizes that nobody should pass: none may crash, hang or reach somebody else's pixel.
#include <cstdint>
#include <functional>
#include <limits>

#include "extremes_fixture.h"

namespace conformance {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                kInfinity = std::numeric_limits<float>::infinity();
constexpr Vec4 kGreen = {0, 1, 0, 1};

class BadInput : public ExtremesFixture {};

// A broken triangle among three: the other two are drawn as if it were not there.
TEST_F(BadInput, BadNumbersInPositions) {
  for (float bad : {kNan, kInfinity, -kInfinity, 1e38f, -1e38f, 1e-45f, 3.4e38f}) {
    for (int component = 0; component < 4; ++component) {
      glClear(GL_COLOR_BUFFER_BIT);
      std::vector<GLfloat> positions = {-1,    -1, 0, 1, -0.1f, -1, 0, 1, -1, 1,    0, 1,   // left
                                        -0.2f, 0,  0, 1, 0.2f,  0,  0, 1, 0,  0.5f, 0, 1,   // the broken one
                                        0.1f,  -1, 0, 1, 1,     -1, 0, 1, 1,  1,    0, 1};  // right
      positions[static_cast<std::size_t>(12 + 4 + component)] = bad;
      glEnableClientState(GL_VERTEX_ARRAY);
      glVertexPointer(4, GL_FLOAT, 0, positions.data());
      glColor4f(0, 1, 0, 1);
      glDrawArrays(GL_TRIANGLES, 0, 9);
      EXPECT_PIXEL(4, 20, kGreen) << bad << " in component " << component;
      EXPECT_PIXEL(60, 20, kGreen) << bad << " in component " << component;
    }
  }
  expectUnharmed("bad positions");
}

TEST_F(BadInput, BadNumbersInColors) {
  for (float bad : {kNan, kInfinity, -kInfinity}) {
    glClear(GL_COLOR_BUFFER_BIT);
    const GLfloat positions[] = {-1, -1, 0, -1, -1, 1, 0, -1, 1, -1, 1, 1};
    GLfloat colors[24];
    for (int i = 0; i < 24; ++i) colors[i] = i % 4 == 1 || i % 4 == 3 ? 1.0f : 0.0f;
    colors[0] = colors[4] = colors[8] = bad;
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, positions);
    glColorPointer(4, GL_FLOAT, 0, colors);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    EXPECT_PIXEL(60, 10, kGreen) << bad;
  }
  expectUnharmed("bad colours");
}

struct StateCase {
  const char* name;
  std::function<void()> set;
};

// Numbers that no formula likes, put everywhere; a quad and a point are drawn under each.
TEST_F(BadInput, BadNumbersInState) {
  const auto matrix = [](GLenum mode, float value, int index) {
    return [=] {
      GLfloat m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      m[index] = value;
      glMatrixMode(mode);
      glLoadMatrixf(m);
    };
  };
  const auto light = [](GLenum name, float value) {
    return [=] {
      const GLfloat values[] = {value, value, value, value};
      glEnable(GL_LIGHTING);
      glEnable(GL_LIGHT0);
      glLightfv(GL_LIGHT0, name, values);
    };
  };
  std::vector<StateCase> cases;
  for (float bad : {kNan, kInfinity, 1e38f, 1e-40f}) {
    cases.push_back({"modelview", matrix(GL_MODELVIEW, bad, 0)});
    cases.push_back({"modelview w", matrix(GL_MODELVIEW, bad, 15)});
    cases.push_back({"projection", matrix(GL_PROJECTION, bad, 5)});
    cases.push_back({"texture", matrix(GL_TEXTURE, bad, 0)});
    cases.push_back({"light position", light(GL_POSITION, bad)});
    cases.push_back({"light colour", light(GL_DIFFUSE, bad)});
    cases.push_back({"spot direction", light(GL_SPOT_DIRECTION, bad)});
    cases.push_back({"normal", [=] {
                       glEnable(GL_LIGHTING);
                       glEnable(GL_LIGHT0);
                       glNormal3f(bad, bad, bad);
                     }});
    cases.push_back({"colour", [=] { glColor4f(bad, bad, bad, bad); }});
    cases.push_back({"clear colour", [=] { glClearColor(bad, bad, bad, bad); }});
    cases.push_back({"depth range", [=] { glDepthRangef(bad, bad); }});
    cases.push_back({"clear depth", [=] { glClearDepthf(bad); }});
    cases.push_back({"alpha reference", [=] {
                       glEnable(GL_ALPHA_TEST);
                       glAlphaFunc(GL_LESS, bad);
                     }});
    cases.push_back({"fog", [=] {
                       glEnable(GL_FOG);
                       glFogf(GL_FOG_DENSITY, bad);
                       glFogf(GL_FOG_START, bad);
                       glFogf(GL_FOG_END, bad);
                     }});
    cases.push_back({"linear fog", [=] {
                       glEnable(GL_FOG);
                       glFogf(GL_FOG_MODE, GL_LINEAR);
                       glFogf(GL_FOG_END, bad);
                     }});
    cases.push_back({"polygon offset", [=] {
                       glEnable(GL_POLYGON_OFFSET_FILL);
                       glPolygonOffset(bad, bad);
                     }});
    cases.push_back({"line width", [=] { glLineWidth(bad); }});
    cases.push_back({"point size", [=] { glPointSize(bad); }});
    cases.push_back({"point attenuation", [=] {
                       const GLfloat values[] = {bad, bad, bad};
                       glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, values);
                     }});
    cases.push_back({"clip plane", [=] {
                       const GLfloat plane[] = {bad, bad, bad, bad};
                       glClipPlanef(GL_CLIP_PLANE0, plane);
                       glEnable(GL_CLIP_PLANE0);
                     }});
    cases.push_back({"texture coordinate", [=] {
                       solidTexture(GL_RGBA, {1, 2, 3, 4});
                       glEnable(GL_TEXTURE_2D);
                       glMultiTexCoord4f(GL_TEXTURE0, bad, bad, bad, bad);
                     }});
    cases.push_back({"environment colour", [=] {
                       const GLfloat values[] = {bad, bad, bad, bad};
                       glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, values);
                     }});
    cases.push_back({"rotation", [=] { glRotatef(bad, bad, bad, bad); }});
    cases.push_back({"frustum", [=] { glFrustumf(-bad, bad, -1, 1, 1, bad); }});
    cases.push_back({"sample coverage", [=] {
                       glEnable(GL_SAMPLE_COVERAGE);
                       glSampleCoverage(bad, GL_FALSE);
                     }});
  }
  for (const StateCase& entry : cases) {
    Session session(SurfaceRequest{});
    ASSERT_TRUE(session.makeCurrent());
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    entry.set();
    drawRect();
    const GLfloat point[] = {0.5f, 0.5f};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, point);
    glDrawArrays(GL_POINTS, 0, 1);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDepthRangef(0, 1);
    glDisable(GL_ALPHA_TEST);
    glDisable(GL_POLYGON_OFFSET_FILL);
    expectUnharmed(entry.name);
  }
  // The fixture's own context again, for its last check.
  SetUp();
}

// Degenerate primitives of every mode draw nothing or little, and crash nobody.
TEST_F(BadInput, DegeneratePrimitives) {
  const std::vector<GLfloat> same(64, 0.25f);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, same.data());
  for (GLenum mode = GL_POINTS; mode <= GL_TRIANGLE_FAN; ++mode) {
    for (GLsizei count = 0; count < 9; ++count) glDrawArrays(mode, 0, count);
  }
  expectUnharmed("degenerate primitives");
}

// Arrays that are enabled without a pointer, strides and indices beyond every buffer.
TEST_F(BadInput, ReadsBeyondBuffers) {
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  const GLfloat triangle[] = {-1, -1, 3, -1, -1, 3};
  glBufferData(GL_ARRAY_BUFFER, sizeof triangle, triangle, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  const auto pointer = [](std::uintptr_t offset) { return reinterpret_cast<const void*>(offset); };
  const GLushort wild[] = {0, 60000, 65535, 1, 2, 3};
  for (GLsizei stride : {0, 8, 1, 7, 1000000, std::numeric_limits<GLsizei>::max()}) {
    for (std::uintptr_t offset : {std::uintptr_t{0}, std::uintptr_t{20}, std::uintptr_t{24},
                                  std::uintptr_t{1} << 40, ~std::uintptr_t{0}}) {
      glVertexPointer(2, GL_FLOAT, stride, pointer(offset));
      glDrawArrays(GL_TRIANGLES, 0, 3);
      glDrawArrays(GL_TRIANGLES, 1000000, 3);
      glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, wild);
    }
  }
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLES, std::numeric_limits<GLint>::max() - 3, 3);
  // Indices from a buffer that is too short for them.
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  const GLubyte three[] = {0, 1, 2};
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof three, three, GL_STATIC_DRAW);
  glDrawElements(GL_TRIANGLES, 300, GL_UNSIGNED_SHORT, nullptr);
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, pointer(~std::uintptr_t{0}));
  // An empty buffer behind an array.
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  glBufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STATIC_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, wild);
  expectUnharmed("reads beyond buffers");
}

TEST_F(BadInput, NullPointers) {
  MESA_DISAGREES("2.8", "null client arrays are read");
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const GLushort indices[] = {0, 1, 2};
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, indices);
  const GLfloat triangle[] = {-1, -1, 3, -1, -1, 3};
  glVertexPointer(2, GL_FLOAT, 0, triangle);
  for (GLenum array : {GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_POINT_SIZE_ARRAY_OES}) {
    glEnableClientState(static_cast<GLenum>(array));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDrawArrays(GL_POINTS, 0, 3);
    glDisableClientState(static_cast<GLenum>(array));
  }
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr);
  expectUnharmed("null pointers");
}

// 2.7: MultiTexCoord4 on a unit that is not there is undefined, not fatal.
TEST_F(BadInput, TextureUnitsBeyond) {
  for (GLenum unit : {GLenum{0}, GLenum{GL_TEXTURE0 - 1}, GLenum{GL_TEXTURE31}, GLenum{0xffffffff}}) {
    glMultiTexCoord4f(unit, 1, 2, 3, 4);
    glMultiTexCoord4x(unit, 1, 2, 3, 4);
  }
  expectUnharmed("texture units");
}

// Out of memory is an error, not a crash.
TEST_F(BadInput, HugeAllocations) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, std::numeric_limits<GLsizeiptr>::max() / 2, nullptr, GL_STATIC_DRAW);
  const GLenum error = glGetError();
  EXPECT_TRUE(error == GL_OUT_OF_MEMORY || error == GL_INVALID_VALUE) << errorName(error);
  expectUnharmed("huge buffer");
}

}  // namespace
}  // namespace conformance
