// EXT_robustness: reads into buffers of a known size, and resets.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "extension_commands.h"
#include "other_context.h"

namespace conformance {
namespace {

class Robustness : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    NEEDS_EXTENSION("GL_EXT_robustness");
  }
};

TEST_F(Robustness, ContextState) {
  GLint value = -1;
  glGetIntegerv(GL_CONTEXT_ROBUST_ACCESS_EXT, &value);
  EXPECT_EQ(value, 0);
  glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_EXT, &value);
  EXPECT_EQ(value, GL_NO_RESET_NOTIFICATION_EXT);
  COMMAND(PFNGLGETGRAPHICSRESETSTATUSEXTPROC, GetGraphicsResetStatusEXT);
  EXPECT_EQ(GetGraphicsResetStatusEXT(), GLenum{GL_NO_ERROR});
  const OtherContext told({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
  ASSERT_TRUE(told.valid());
  glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_EXT, &value);
  EXPECT_EQ(value, GL_LOSE_CONTEXT_ON_RESET_EXT);
  EXPECT_EQ(GetGraphicsResetStatusEXT(), GLenum{GL_NO_ERROR});
  drawRect();
  glFinish();
  EXPECT_EQ(GetGraphicsResetStatusEXT(), GLenum{GL_NO_ERROR});
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// Exactly the bytes that ReadPixels would write, or none.
TEST_F(Robustness, ReadnPixels) {
  COMMAND(PFNGLREADNPIXELSEXTPROC, ReadnPixelsEXT);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const struct {
    GLsizei width, height;
    GLint alignment;
    GLsizei needed;
  } rows[] = {{4, 4, 4, 64}, {3, 5, 8, 4 * 16 + 12}, {1, 1, 8, 4}, {0, 7, 4, 0}, {7, 0, 4, 0}};
  for (const auto& row : rows) {
    glPixelStorei(GL_PACK_ALIGNMENT, row.alignment);
    std::vector<std::uint8_t> out(static_cast<std::size_t>(row.needed) + 16, 0x55);
    ReadnPixelsEXT(2, 2, row.width, row.height, GL_RGBA, GL_UNSIGNED_BYTE, row.needed, out.data());
    EXPECT_GL_ERROR(GL_NO_ERROR);
    EXPECT_EQ(std::count(out.end() - 16, out.end(), 0x55), 16);
    if (row.needed == 0) continue;
    EXPECT_EQ(out[0], 255);
    EXPECT_EQ(out[1], 0);
    EXPECT_EQ(out[static_cast<std::size_t>(row.needed) - 1], 255);

    std::fill(out.begin(), out.end(), std::uint8_t{0x55});
    for (const GLsizei room : {row.needed - 1, 0, -1}) {
      ReadnPixelsEXT(2, 2, row.width, row.height, GL_RGBA, GL_UNSIGNED_BYTE, room, out.data());
      EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    }
    EXPECT_EQ(std::count(out.begin(), out.end(), 0x55), static_cast<std::ptrdiff_t>(out.size()));
  }
  // What hangs over the edge counts, too.
  std::vector<std::uint8_t> out(64);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  ReadnPixelsEXT(62, 62, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, 63, out.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  ReadnPixelsEXT(62, 62, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, 64, out.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_EQ(out[0], 255);
}

// The errors of ReadPixels come first.
TEST_F(Robustness, ReadnPixelsErrors) {
  COMMAND(PFNGLREADNPIXELSEXTPROC, ReadnPixelsEXT);
  std::uint8_t out[64];
  ReadnPixelsEXT(0, 0, 1, 1, GL_TEXTURE_2D, GL_UNSIGNED_BYTE, 64, out);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  ReadnPixelsEXT(0, 0, 1, 1, GL_RGBA, GL_FLOAT, 64, out);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  ReadnPixelsEXT(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 64, out);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  ReadnPixelsEXT(0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, 64, out);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

// Indices and arrays beyond their buffers' ends draw something or nothing, and harm nobody.
TEST_F(Robustness, ReadsBeyondBuffers) {
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  const GLfloat positions[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  const GLushort indices[] = {0, 1, 2, 3, 60000, 1, 2, 65535};
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glDrawElements(GL_TRIANGLES, 8, GL_UNSIGNED_SHORT, nullptr);
  glDrawElements(GL_TRIANGLES, 300, GL_UNSIGNED_SHORT, nullptr);
  glDrawArrays(GL_TRIANGLES, 0, 3000);
  glFinish();
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4f(0, 1, 0, 1);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, nullptr);
  EXPECT_PIXEL(32, 32, {0, 1, 0, 1});
}

}  // namespace
}  // namespace conformance
