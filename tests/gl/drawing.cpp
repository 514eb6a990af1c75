// Sections 2.8 and 4.2.3: what reaches the renderer, and what does not.
#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

constexpr GLfloat kVertices[32] = {};

class Drawing : public GlTest {
 protected:
  Drawing() {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kVertices);
  }
  size_t draws() { return renderer().draws.size(); }
  GLuint buffer(GLenum target, GLsizeiptr size) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, size, nullptr, GL_STATIC_DRAW);
    return name;
  }
};

}  // namespace

TEST_F(Drawing, CarriesTheCallAndThePrimitive) {
  glDrawArrays(GL_LINE_LOOP, 2, 5);
  ASSERT_EQ(draws(), 1u);
  const render::DrawCall& call = renderer().draws[0].call;
  EXPECT_EQ(call.mode, GLenum{GL_LINE_LOOP});
  EXPECT_EQ(call.first, 2);
  EXPECT_EQ(call.count, 5);
  EXPECT_EQ(call.indexType, 0u);
  EXPECT_EQ(state().fixed.primitive, gen::PrimitiveClass::Lines);
}

TEST_F(Drawing, ASecondEqualDrawFindsNothingMarked) {
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glVertexPointer(3, GL_FLOAT, 12, kVertices);  // the same place and stride in other words
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 3);
  glColor4f(1, 0, 0, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawArrays(GL_POINTS, 0, 3);
  ASSERT_EQ(draws(), 5u);
  EXPECT_EQ(renderer().draws[1].changed, 0u);
  EXPECT_EQ(renderer().draws[2].changed, 0u);
  EXPECT_EQ(renderer().draws[3].changed, gen::Groups{gen::kGroupCurrentColor});
  EXPECT_EQ(renderer().draws[4].changed, gen::Groups{gen::kGroupPrimitive});
}

TEST_F(Drawing, ADrawThatFailedSettlesNothing) {
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColor4f(1, 0, 0, 1);
  device.log.outOfMemory = true;
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
  device.log.outOfMemory = false;
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ASSERT_EQ(draws(), 4u);
  EXPECT_EQ(renderer().draws[2].changed, gen::Groups{gen::kGroupCurrentColor});
  EXPECT_EQ(renderer().draws[3].changed, 0u);
}

TEST_F(Drawing, AClearSettlesNothing) {
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColor4f(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(renderer().draws[1].changed, gen::Groups{gen::kGroupCurrentColor});
}

// OES_draw_texture: its state is another one, and the next draw is told so.
TEST_F(Drawing, ARectangleLeavesTheStateAlone) {
  glEnable(GL_CULL_FACE);
  glTranslatef(1, 2, 3);
  glDrawArrays(GL_LINES, 0, 2);
  const gen::State before = state().fixed;
  glDrawTexiOES(1, 2, 0, 3, 4);
  EXPECT_EQ(state().fixed.modelview, before.modelview);
  EXPECT_EQ(state().fixed.projection, before.projection);
  EXPECT_EQ(state().fixed.primitive, gen::PrimitiveClass::Lines);
  EXPECT_TRUE(state().raster.cullFace);
  glDrawArrays(GL_LINES, 0, 2);
  ASSERT_EQ(draws(), 3u);
  EXPECT_EQ(renderer().draws[1].primitive, gen::PrimitiveClass::Triangles);
  for (size_t i : {1u, 2u}) {
    EXPECT_TRUE(renderer().draws[i].changed & gen::kGroupModelview);
    EXPECT_TRUE(renderer().draws[i].changed & gen::kGroupRaster);
    EXPECT_TRUE(renderer().draws[i].changed & gen::kGroupPrimitive);
    EXPECT_FALSE(renderer().draws[i].changed & gen::kGroupFog);
  }
}

TEST_F(Drawing, ArraysReachTheRenderer) {
  static const GLubyte colors[64] = {};
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_UNSIGNED_BYTE, 8, colors);
  glClientActiveTexture(GL_TEXTURE2);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_SHORT, 0, kVertices);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const auto& attributes = state().fixed.attributes;
  EXPECT_TRUE(attributes[gen::kColor].array);
  EXPECT_EQ(attributes[gen::kColor].type, GLenum{GL_UNSIGNED_BYTE});
  EXPECT_EQ(state().arrays[gen::kColor].stride, 8u);
  EXPECT_EQ(state().arrays[gen::kColor].pointer, colors);
  EXPECT_TRUE(attributes[gen::texCoord(2)].array);
  EXPECT_EQ(attributes[gen::texCoord(2)].size, 2);
  EXPECT_EQ(state().arrays[gen::texCoord(2)].stride, 4u);
  EXPECT_EQ(state().arrays[gen::kPosition].stride, 12u);
  EXPECT_FALSE(attributes[gen::kNormal].array);

  glDisableClientState(GL_COLOR_ARRAY);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_FALSE(attributes[gen::kColor].array);
}

TEST_F(Drawing, NothingToDrawDrawsNothing) {
  glDrawArrays(GL_TRIANGLES, 0, 0);
  glDrawArrays(GL_TRIANGLES, 0, 2);
  glDrawArrays(GL_LINES, 0, 1);
  glDrawElements(GL_POINTS, 0, GL_UNSIGNED_SHORT, kVertices);
  glDrawElements(GL_POINTS, 1, GL_UNSIGNED_SHORT, nullptr);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, kVertices);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(draws(), 0u);
}

TEST_F(Drawing, AnArrayWithoutMemoryGivesTheCurrentValue) {
  glEnableClientState(GL_COLOR_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(draws(), 1u);
  EXPECT_FALSE(state().fixed.attributes[gen::kColor].array);
  EXPECT_FALSE(state().fixed.attributes[gen::kNormal].array);
}

TEST_F(Drawing, VertexCountsThatOverflowAreRefused) {
  glDrawArrays(GL_POINTS, 0x7FFFFFFF, 2);
  EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
  EXPECT_EQ(draws(), 0u);
}

TEST_F(Drawing, BufferObjectsAreUsedInPlace) {
  const GLuint name = buffer(GL_ARRAY_BUFFER, 100);
  glVertexPointer(2, GL_SHORT, 20, reinterpret_cast<const void*>(8));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BUFFER_BINDING), static_cast<GLint>(name));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ASSERT_EQ(draws(), 1u);
  ASSERT_NE(state().arrays[gen::kPosition].buffer, nullptr);
  EXPECT_EQ(state().arrays[gen::kPosition].buffer->size(), 100u);
  EXPECT_EQ(state().arrays[gen::kPosition].pointer, reinterpret_cast<const void*>(8));
}

TEST_F(Drawing, AReplacedStoreIsSeenByTheNextDraw) {
  buffer(GL_ARRAY_BUFFER, 100);
  glVertexPointer(2, GL_SHORT, 0, nullptr);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBufferData(GL_ARRAY_BUFFER, 200, nullptr, GL_STATIC_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  ASSERT_EQ(draws(), 2u);
  EXPECT_EQ(state().arrays[gen::kPosition].buffer->size(), 200u);
  EXPECT_TRUE(renderer().draws[1].changed & gen::kGroupArrays);
  glBufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STATIC_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(draws(), 2u);
}

TEST_F(Drawing, AStoreThatAnotherContextReplacedIsSeenByTheNextDraw) {
  const GLuint name = buffer(GL_ARRAY_BUFFER, 100);
  glVertexPointer(2, GL_SHORT, 0, nullptr);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const ContextPtr other = createContext(device, context.get(), {});
  makeCurrent(other.get());
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glBufferData(GL_ARRAY_BUFFER, 200, nullptr, GL_STATIC_DRAW);
  makeCurrent(context.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(state().arrays[gen::kPosition].buffer->size(), 200u);
  EXPECT_EQ(renderer().draws.back().changed, gen::Groups{gen::kGroupArrays});
}

TEST_F(Drawing, ADeletedBufferIsNotReadAgain) {
  const GLuint name = buffer(GL_ARRAY_BUFFER, 100);
  glVertexPointer(2, GL_SHORT, 0, reinterpret_cast<const void*>(16));
  glDeleteBuffers(1, &name);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(draws(), 0u);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
}

TEST_F(Drawing, IndicesBeyondTheirBufferDrawNothing) {
  buffer(GL_ELEMENT_ARRAY_BUFFER, 12);
  glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr);
  ASSERT_EQ(draws(), 1u);
  EXPECT_NE(renderer().draws[0].call.indexBuffer, nullptr);
  glDrawElements(GL_TRIANGLES, 7, GL_UNSIGNED_SHORT, nullptr);
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, reinterpret_cast<const void*>(10));
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, reinterpret_cast<const void*>(-1));
  EXPECT_EQ(draws(), 1u);
}

TEST_F(Drawing, ClientIndicesArePassedOn) {
  const GLubyte indices[3] = {2, 1, 0};
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
  ASSERT_EQ(draws(), 1u);
  EXPECT_EQ(renderer().draws[0].call.indices, indices);
  EXPECT_EQ(renderer().draws[0].call.indexBuffer, nullptr);
}

TEST_F(Drawing, ClearsReachTheRenderer) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glClear(0);
  ASSERT_EQ(renderer().clears.size(), 1u);
  EXPECT_EQ(renderer().clears[0], GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT});
}

}  // namespace anteroom::gl::test
