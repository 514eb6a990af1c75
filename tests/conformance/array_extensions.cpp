// OES_element_index_uint, EXT_multi_draw_arrays, OES_mapbuffer, EXT_map_buffer_range,
// OES_vertex_array_object, EXT_debug_marker.
#include <cstring>

#include "extension_commands.h"

namespace conformance {
namespace {

class ArrayExtensions : public GlTest {};

constexpr Vec4 kBlack = {0, 0, 0, 0}, kGreen = {0, 1, 0, 1};
// The left half, then the right half, as strips.
constexpr GLfloat kHalves[] = {-1, -1, 0, -1, -1, 1, 0, 1, 0, -1, 1, -1, 0, 1, 1, 1};
constexpr GLfloat kFull[] = {-1, -1, 1, -1, -1, 1, 1, 1};

GLint get(GLenum name) {
  GLint value = -1;
  glGetIntegerv(name, &value);
  return value;
}

void start() {
  glClear(GL_COLOR_BUFFER_BIT);
  glColor4f(0, 1, 0, 1);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kHalves);
}

GLuint buffer(GLenum target, GLsizeiptr size, const void* data) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(target, name);
  glBufferData(target, size, data, GL_DYNAMIC_DRAW);
  return name;
}

// Indices beyond what 16 bits hold, from client memory and from a buffer.
TEST_F(ArrayExtensions, UnsignedIntIndices) {
  NEEDS_EXTENSION("GL_OES_element_index_uint");
  constexpr GLuint kFirst = 70000;
  std::vector<GLfloat> vertices(2 * kFirst);
  vertices.insert(vertices.end(), kFull, kFull + 8);
  const GLuint indices[] = {kFirst, kFirst + 1, kFirst + 2, kFirst + 3};
  start();
  glVertexPointer(2, GL_FLOAT, 0, vertices.data());
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_INT, indices);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_PIXEL(32, 32, kGreen);

  glClear(GL_COLOR_BUFFER_BIT);
  buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices);
  buffer(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GLfloat)), vertices.data());
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_INT, nullptr);
  EXPECT_PIXEL(32, 32, kGreen);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(ArrayExtensions, MultiDraw) {
  NEEDS_EXTENSION("GL_EXT_multi_draw_arrays");
  COMMAND(PFNGLMULTIDRAWARRAYSEXTPROC, MultiDrawArraysEXT);
  COMMAND(PFNGLMULTIDRAWELEMENTSEXTPROC, MultiDrawElementsEXT);
  const GLint first[] = {0, 1000000, 4};
  const GLsizei counts[] = {4, 0, 4};  // the second list is empty
  start();
  MultiDrawArraysEXT(GL_TRIANGLE_STRIP, first, counts, 1);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, kBlack);
  MultiDrawArraysEXT(GL_TRIANGLE_STRIP, first, counts, 3);
  EXPECT_PIXEL(48, 32, kGreen);

  glClear(GL_COLOR_BUFFER_BIT);
  const GLubyte left[] = {0, 1, 2, 3}, right[] = {4, 5, 6, 7};
  const void* lists[] = {left, left, right};
  MultiDrawElementsEXT(GL_TRIANGLE_STRIP, counts, GL_UNSIGNED_BYTE, lists, 3);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, kGreen);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  MultiDrawArraysEXT(GL_TRIANGLE_STRIP, first, counts, -1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  MultiDrawElementsEXT(GL_TRIANGLE_STRIP, counts, GL_UNSIGNED_BYTE, lists, -1);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  MultiDrawArraysEXT(GL_TRIANGLE_FAN + 1, first, counts, 1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

// What is written through the pointer is drawn; what is not written stays.
TEST_F(ArrayExtensions, MapBuffer) {
  NEEDS_EXTENSION("GL_OES_mapbuffer");
  COMMAND(PFNGLMAPBUFFEROESPROC, MapBufferOES);
  COMMAND(PFNGLUNMAPBUFFEROESPROC, UnmapBufferOES);
  COMMAND(PFNGLGETBUFFERPOINTERVOESPROC, GetBufferPointervOES);
  start();
  buffer(GL_ARRAY_BUFFER, sizeof kHalves, kHalves);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  GLint state = -1;
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_ACCESS_OES, &state);
  EXPECT_EQ(state, GL_WRITE_ONLY_OES);
  auto* floats = static_cast<GLfloat*>(MapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES));
  ASSERT_NE(floats, nullptr);
  void* pointer = nullptr;
  GetBufferPointervOES(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER_OES, &pointer);
  EXPECT_EQ(pointer, floats);
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED_OES, &state);
  EXPECT_EQ(state, GL_TRUE);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_EQ(MapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glBufferSubData(GL_ARRAY_BUFFER, 0, 4, kFull);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  floats[2] = floats[6] = 1;  // the left half reaches to the right
  EXPECT_EQ(UnmapBufferOES(GL_ARRAY_BUFFER), GL_TRUE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, kGreen);

  GetBufferPointervOES(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER_OES, &pointer);
  EXPECT_EQ(pointer, nullptr);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_EQ(UnmapBufferOES(GL_ARRAY_BUFFER), GL_FALSE);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(MapBufferOES(GL_ARRAY_BUFFER, GL_STATIC_DRAW), nullptr);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  EXPECT_EQ(MapBufferOES(GL_TEXTURE_2D, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  EXPECT_EQ(MapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES), nullptr);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

// OES_mapbuffer: what cannot be mapped is OUT_OF_MEMORY and NULL: a store that was never given, is empty or could not be had.
TEST_F(ArrayExtensions, EmptyStoresAreNotMapped) {
  NEEDS_EXTENSION("GL_OES_mapbuffer");
  MESA_DISAGREES("OES_mapbuffer", "empty stores are mapped");
  COMMAND(PFNGLMAPBUFFEROESPROC, MapBufferOES);
  const GLuint name = buffer(GL_ARRAY_BUFFER, 0, nullptr);
  for (const bool failed : {false, true}) {
    if (failed) {
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr{1} << 40, nullptr, GL_STATIC_DRAW);
      EXPECT_GL_ERROR(GL_OUT_OF_MEMORY);
    }
    EXPECT_EQ(MapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES), nullptr) << failed;
    EXPECT_GL_ERROR(GL_OUT_OF_MEMORY) << failed;
    GLint mapped = -1;
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED_OES, &mapped);
    EXPECT_EQ(mapped, GL_FALSE) << failed;
  }
  glDeleteBuffers(1, &name);
}

TEST_F(ArrayExtensions, MapBufferRange) {
  NEEDS_EXTENSION("GL_EXT_map_buffer_range");
  COMMAND(PFNGLMAPBUFFERRANGEEXTPROC, MapBufferRangeEXT);
  COMMAND(PFNGLFLUSHMAPPEDBUFFERRANGEEXTPROC, FlushMappedBufferRangeEXT);
  COMMAND(PFNGLUNMAPBUFFEROESPROC, UnmapBufferOES);
  start();
  buffer(GL_ARRAY_BUFFER, sizeof kHalves, kHalves);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  const auto map = [&](GLintptr offset, GLsizeiptr size, GLbitfield access) {
    return static_cast<GLfloat*>(MapBufferRangeEXT(GL_ARRAY_BUFFER, offset, size, access));
  };
  // The vertex of the lower right corner, and the flushed part of the upper one's.
  GLfloat* floats = map(8, 8, GL_MAP_WRITE_BIT_EXT | GL_MAP_INVALIDATE_RANGE_BIT_EXT);
  ASSERT_NE(floats, nullptr);
  floats[0] = 1, floats[1] = -1;
  EXPECT_EQ(UnmapBufferOES(GL_ARRAY_BUFFER), GL_TRUE);
  floats = map(16, 16, GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT);
  ASSERT_NE(floats, nullptr);
  floats[2] = 1;
  FlushMappedBufferRangeEXT(GL_ARRAY_BUFFER, 8, 4);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  FlushMappedBufferRangeEXT(GL_ARRAY_BUFFER, 8, 9);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  FlushMappedBufferRangeEXT(GL_ARRAY_BUFFER, -1, 4);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  EXPECT_EQ(UnmapBufferOES(GL_ARRAY_BUFFER), GL_TRUE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(48, 32, kGreen);
  EXPECT_PIXEL(60, 60, kGreen);
  floats = map(8, 4, GL_MAP_READ_BIT_EXT);
  ASSERT_NE(floats, nullptr);
  EXPECT_EQ(floats[0], 1);
  EXPECT_EQ(map(0, 4, GL_MAP_READ_BIT_EXT), nullptr);  // mapped already
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  FlushMappedBufferRangeEXT(GL_ARRAY_BUFFER, 0, 4);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  EXPECT_EQ(UnmapBufferOES(GL_ARRAY_BUFFER), GL_TRUE);

  const struct {
    GLintptr offset;
    GLsizeiptr size;
    GLbitfield access;
    GLenum error;
  } bad[] = {{-1, 4, GL_MAP_READ_BIT_EXT, GL_INVALID_VALUE},
             {0, -4, GL_MAP_READ_BIT_EXT, GL_INVALID_VALUE},
             {0, sizeof kHalves + 1, GL_MAP_READ_BIT_EXT, GL_INVALID_VALUE},
             {0, 4, GL_MAP_READ_BIT_EXT | 0x8000, GL_INVALID_VALUE},
             {0, 0, GL_MAP_READ_BIT_EXT, GL_INVALID_OPERATION},
             {0, 4, 0, GL_INVALID_OPERATION},
             {0, 4, GL_MAP_READ_BIT_EXT | GL_MAP_INVALIDATE_BUFFER_BIT_EXT, GL_INVALID_OPERATION},
             {0, 4, GL_MAP_READ_BIT_EXT | GL_MAP_UNSYNCHRONIZED_BIT_EXT, GL_INVALID_OPERATION},
             {0, 4, GL_MAP_READ_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT, GL_INVALID_OPERATION}};
  for (const auto& row : bad) {
    EXPECT_EQ(map(row.offset, row.size, row.access), nullptr);
    EXPECT_GL_ERROR(row.error) << row.offset << " " << row.size << " " << row.access;
  }
}

TEST_F(ArrayExtensions, VertexArrayObjects) {
  MESA_DISAGREES("OES_vertex_array_object", "GenVertexArraysOES gives no names to ES 1 contexts");
  NEEDS_EXTENSION("GL_OES_vertex_array_object");
  COMMAND(PFNGLBINDVERTEXARRAYOESPROC, BindVertexArrayOES);
  COMMAND(PFNGLGENVERTEXARRAYSOESPROC, GenVertexArraysOES);
  COMMAND(PFNGLDELETEVERTEXARRAYSOESPROC, DeleteVertexArraysOES);
  COMMAND(PFNGLISVERTEXARRAYOESPROC, IsVertexArrayOES);
  start();
  EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING_OES), 0);
  GLuint names[2] = {};
  GenVertexArraysOES(2, names);
  EXPECT_FALSE(IsVertexArrayOES(names[0]));
  const GLubyte indices[] = {4, 5, 6, 7};
  for (int i = 0; i < 2; ++i) {
    BindVertexArrayOES(names[i]);
    EXPECT_TRUE(IsVertexArrayOES(names[i]));
    EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY));
    EXPECT_EQ(get(GL_VERTEX_ARRAY_SIZE), 4);
    EXPECT_EQ(get(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
    buffer(GL_ARRAY_BUFFER, sizeof kHalves, kHalves);
    glVertexPointer(2, GL_FLOAT, 0, reinterpret_cast<const void*>(i == 0 ? 0 : 32));
    glEnableClientState(GL_VERTEX_ARRAY);
    if (i == 0) buffer(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);  // the second: the right half
  EXPECT_PIXEL(16, 32, kBlack);
  EXPECT_PIXEL(48, 32, kGreen);
  BindVertexArrayOES(names[0]);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(16, 32, kGreen);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_PIXEL(16, 32, kBlack);
  EXPECT_PIXEL(48, 32, kGreen);

  // Client memory has no place in an object.
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glVertexPointer(2, GL_FLOAT, 0, kHalves);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  EXPECT_GL_ERROR(GL_NO_ERROR);

  // Name 0 has kept what it had.
  DeleteVertexArraysOES(2, names);
  EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING_OES), 0);
  EXPECT_FALSE(IsVertexArrayOES(names[0]));
  EXPECT_TRUE(glIsEnabled(GL_VERTEX_ARRAY));
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, kBlack);
  EXPECT_GL_ERROR(GL_NO_ERROR);

  BindVertexArrayOES(names[0]);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  BindVertexArrayOES(12345);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  GenVertexArraysOES(-1, names);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  DeleteVertexArraysOES(-1, names);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

// Markers change nothing and are never an error.
TEST_F(ArrayExtensions, DebugMarkers) {
  NEEDS_EXTENSION("GL_EXT_debug_marker");
  COMMAND(PFNGLINSERTEVENTMARKEREXTPROC, InsertEventMarkerEXT);
  COMMAND(PFNGLPUSHGROUPMARKEREXTPROC, PushGroupMarkerEXT);
  COMMAND(PFNGLPOPGROUPMARKEREXTPROC, PopGroupMarkerEXT);
  start();
  PopGroupMarkerEXT();
  PushGroupMarkerEXT(0, nullptr);
  PushGroupMarkerEXT(5, "group with more");
  InsertEventMarkerEXT(0, "event");
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  PopGroupMarkerEXT();
  PopGroupMarkerEXT();
  PopGroupMarkerEXT();
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
