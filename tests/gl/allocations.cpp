// The steady draw path allocates nothing, whatever a frame changes between its draws.
#include <cstdlib>
#include <new>

#include "tests/gl/gl_fixture.h"

namespace {
thread_local size_t allocations = 0;
}

void* operator new(size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

namespace anteroom::gl::test {

namespace {

void frame(const GLuint (&textures)[2], GLuint buffer) {
  static const GLfloat vertices[32] = {};
  static const GLushort indices[6] = {};
  for (int i = 0; i < 10; ++i) {
    glPushMatrix();
    glTranslatef(static_cast<GLfloat>(i), 0, 0);
    glColor4ub(static_cast<GLubyte>(i), 0, 0, 255);
    glBindTexture(GL_TEXTURE_2D, textures[i & 1]);
    glBindBuffer(GL_ARRAY_BUFFER, i & 1 ? buffer : 0);
    glVertexPointer(3, GL_FLOAT, 0, i & 1 ? nullptr : vertices);
    (i & 2 ? glEnable : glDisable)(GL_BLEND);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, i & 4 ? GL_REPLACE : GL_MODULATE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_SHORT, indices);
    glPopMatrix();
  }
}

}  // namespace

using Allocations = GlTest;

TEST_F(Allocations, ASteadyFrameAllocatesNothing) {
  GLuint textures[2] = {}, buffer = 0;
  glGenTextures(2, textures);
  static const GLubyte texels[16] = {};
  for (GLuint texture : textures) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  }
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 256, nullptr, GL_STATIC_DRAW);
  glEnable(GL_TEXTURE_2D);
  glEnableClientState(GL_VERTEX_ARRAY);
  renderer().draws.reserve(64);

  frame(textures, buffer);
  EXPECT_EQ(renderer().draws.size(), 20u);
  const size_t before = allocations;
  frame(textures, buffer);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(renderer().draws.size(), 40u);
}

}  // namespace anteroom::gl::test
