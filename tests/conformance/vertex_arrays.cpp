// Sections 2.8 and 2.9: every array type, size, stride and offset, from client memory and from buffer
// objects.
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "harness.h"

namespace conformance {
namespace {

class VertexArrays : public GlTest {};

constexpr Vec4 kGreen = {0, 1, 0, 1}, kRed = {1, 0, 0, 1}, kBlack = {0, 0, 0, 0};

std::size_t sizeOf(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

template <class T>
void append(std::vector<std::byte>& bytes, double value) {
  const T converted = static_cast<T>(value);
  const auto* raw = reinterpret_cast<const std::byte*>(&converted);
  bytes.insert(bytes.end(), raw, raw + sizeof(T));
}

void appendValue(std::vector<std::byte>& bytes, GLenum type, double value) {
  switch (type) {
    case GL_BYTE:
      return append<GLbyte>(bytes, value);
    case GL_UNSIGNED_BYTE:
      return append<GLubyte>(bytes, std::round(value * 255));
    case GL_SHORT:
      return append<GLshort>(bytes, value);
    case GL_FIXED:
      return append<GLfixed>(bytes, std::round(value * 65536));
    default:
      return append<GLfloat>(bytes, value);
  }
}

// One attribute of four vertices as bytes, its elements `stride` apart and starting at `offset`.
struct Packed {
  GLenum type;
  int size;
  GLsizei stride;
  std::size_t offset;
  std::vector<std::byte> bytes;
};

Packed pack(GLenum type, int size, std::size_t padding, bool explicitStride, std::size_t offset,
            const std::vector<std::vector<double>>& vertices) {
  const std::size_t tight = sizeOf(type) * static_cast<std::size_t>(size);
  Packed packed{
      type, size, padding || explicitStride ? static_cast<GLsizei>(tight + padding) : 0, offset, {}};
  packed.bytes.reserve(offset + (tight + padding) * vertices.size());
  packed.bytes.assign(offset, std::byte{0x7e});
  for (const auto& vertex : vertices) {
    for (int i = 0; i < size; ++i) appendValue(packed.bytes, type, vertex[static_cast<std::size_t>(i)]);
    packed.bytes.insert(packed.bytes.end(), padding, std::byte{0x7e});
  }
  // Nothing behind the last element may be needed.
  packed.bytes.resize(packed.bytes.size() - padding);
  return packed;
}

struct Layout {
  std::size_t padding;
  bool explicitStride;
  std::size_t offset;
  bool buffered;
};

// Strides and offsets in units of the type's size (2.9.1 asks for that alignment in buffer objects).
std::vector<Layout> layouts(GLenum type) {
  const std::size_t unit = sizeOf(type);
  std::vector<Layout> result;
  for (bool buffered : {false, true}) {
    result.push_back({0, false, 0, buffered});
    result.push_back({0, true, 0, buffered});
    for (std::size_t padding : {unit, 3 * unit, 13 * unit}) result.push_back({padding, true, 0, buffered});
    for (std::size_t offset : {unit, 5 * unit}) result.push_back({2 * unit, true, offset, buffered});
  }
  return result;
}

std::string describe(const char* what, const Packed& packed, bool buffered) {
  return fmt::format("{} type {:#x} size {} stride {} offset {} {}", what, packed.type, packed.size,
                     packed.stride, packed.offset, buffered ? "buffer" : "client");
}

// Puts the bytes where the layout wants them and hands the pointer argument of the gl*Pointer call to `set`.
template <class Set>
void place(const Packed& packed, bool buffered, Set&& set) {
  if (!buffered) {
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    set(packed.bytes.data() + packed.offset);
    return;
  }
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(packed.bytes.size()), packed.bytes.data(),
               GL_STATIC_DRAW);
  set(reinterpret_cast<const void*>(packed.offset));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

const GLfloat kQuad[] = {-1, -1, 1, -1, -1, 1, 1, 1};

// Table 2.4: vertices are short, fixed, float, and byte (OES_byte_coordinates), of 2, 3 or 4 components.
TEST_F(VertexArrays, Positions) {
  Cells cells;
  glEnableClientState(GL_VERTEX_ARRAY);
  glColor4f(0, 1, 0, 1);
  glScalef(0.01f, 0.01f, 0.01f);
  for (GLenum type : {GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT}) {
    for (int size : {2, 3, 4}) {
      const std::vector<std::vector<double>> corners = {
          {-100, -100, 50, 1}, {100, -100, 50, 1}, {-100, 100, 50, 1}, {100, 100, 50, 1}};
      for (const Layout& layout : layouts(type)) {
        const Packed packed = pack(type, size, layout.padding, layout.explicitStride, layout.offset, corners);
        cells.add(describe("vertex", packed, layout.buffered), kGreen, [&] {
          place(packed, layout.buffered,
                [&](const void* pointer) { glVertexPointer(size, type, packed.stride, pointer); });
          glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        });
      }
    }
  }
}

// 2.8: missing components are z = 0, w = 1, and given ones are used.
TEST_F(VertexArrays, PositionComponents) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glColor4f(0, 1, 0, 1);
  Cells cells;
  const struct {
    int size;
    float depth;
  } rows[] = {{2, 0.5f}, {3, 0.75f}, {4, 0.625f}};
  for (const auto& row : rows) {
    for (float depth : {0.5f, 0.75f, 0.625f}) {
      const GLfloat corners[] = {-2, -2, 0.5f, 2, 2, -2, 0.5f, 2, -2, 2, 0.5f, 2, 2, 2, 0.5f, 2};
      glClearDepthf(depth);
      cells.add(fmt::format("size {} against depth {}", row.size, depth),
                depth == row.depth ? kGreen : kBlack, [&] {
                  glClear(GL_DEPTH_BUFFER_BIT);
                  glVertexPointer(row.size, GL_FLOAT, 16, corners);
                  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
                });
    }
  }
}

// Table 2.4, 2.7: colours are ubyte c / 255, fixed or float.
TEST_F(VertexArrays, Colors) {
  Cells cells;
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  const Vec4 color = {0.2, 0.6, 1.0, 0.4};
  for (GLenum type : {GL_UNSIGNED_BYTE, GL_FIXED, GL_FLOAT}) {
    for (const Layout& layout : layouts(type)) {
      const std::vector<double> one(color.begin(), color.end());
      const Packed packed =
          pack(type, 4, layout.padding, layout.explicitStride, layout.offset, {one, one, one, one});
      cells.add(describe("color", packed, layout.buffered), color, [&] {
        place(packed, layout.buffered,
              [&](const void* pointer) { glColorPointer(4, type, packed.stride, pointer); });
        glVertexPointer(2, GL_FLOAT, 0, kQuad);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
      });
    }
  }
}

// Table 2.4, 2.7: normals are byte (2c + 1) / 255, short (2c + 1) / 65535, fixed or float.
TEST_F(VertexArrays, Normals) {
  const GLfloat black[] = {0, 0, 0, 1}, white[] = {1, 1, 1, 1};
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, black);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
  Cells cells;
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  for (GLenum type : {GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT}) {
    const double given = type == GL_BYTE ? 76 : type == GL_SHORT ? 19660 : 0.6;
    const double z = type == GL_BYTE    ? (2 * 76 + 1) / 255.0
                     : type == GL_SHORT ? (2 * 19660 + 1) / 65535.0
                                        : 0.6;
    for (const Layout& layout : layouts(type)) {
      const std::vector<double> one = {0, 0, given};
      const Packed packed =
          pack(type, 3, layout.padding, layout.explicitStride, layout.offset, {one, one, one, one});
      cells.add(describe("normal", packed, layout.buffered), {z, z, z, 1}, [&] {
        place(packed, layout.buffered,
              [&](const void* pointer) { glNormalPointer(type, packed.stride, pointer); });
        glVertexPointer(2, GL_FLOAT, 0, kQuad);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
      });
    }
  }
}

// Table 2.4: texture coordinates are byte, short, fixed or float of 2, 3 or 4 components, on every unit.
TEST_F(VertexArrays, TextureCoordinates) {
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  // Texel (s, t) of a 4x4 image is (s / 5, t / 5, 1).
  std::vector<GLubyte> texels;
  for (int t = 0; t < 4; ++t) {
    for (int s = 0; s < 4; ++s) texels.insert(texels.end(), {GLubyte(s * 51), GLubyte(t * 51), 255, 255});
  }
  GLuint name = 0;
  glGenTextures(1, &name);
  Cells cells;
  glEnableClientState(GL_VERTEX_ARRAY);
  for (int unit : {0, 1, units - 1}) {
    const GLenum index = GL_TEXTURE0 + static_cast<GLenum>(unit);
    glActiveTexture(index);
    glClientActiveTexture(index);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, name);
    useNearest();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScalef(0.125f, 0.125f, 1);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    for (GLenum type : {GL_BYTE, GL_SHORT, GL_FIXED, GL_FLOAT}) {
      for (int size : {2, 3, 4}) {
        for (const Layout& layout : layouts(type)) {
          // (7, 3) / 8 is the middle of texel (3, 1); with q = 2 it is texel (1, 0).
          const std::vector<double> one = {7, 3, 9, 2};
          const Packed packed =
              pack(type, size, layout.padding, layout.explicitStride, layout.offset, {one, one, one, one});
          const Vec4 expected = size == 4 ? Vec4{0.2, 0, 1, 1} : Vec4{0.6, 0.2, 1, 1};
          cells.add(describe("texture coordinate", packed, layout.buffered), expected, [&] {
            place(packed, layout.buffered,
                  [&](const void* pointer) { glTexCoordPointer(size, type, packed.stride, pointer); });
            glVertexPointer(2, GL_FLOAT, 0, kQuad);
            glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
          });
        }
      }
    }
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glDisable(GL_TEXTURE_2D);
  }
}

// 2.8: a disabled array leaves the current value in force; without the vertex array nothing is drawn.
TEST_F(VertexArrays, DisabledArrays) {
  glColor4f(0, 1, 0, 1);
  const GLfloat reds[] = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  glColorPointer(4, GL_FLOAT, 0, reds);
  drawRect();
  EXPECT_PIXEL(32, 32, kGreen);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kQuad);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(32, 32, kGreen);
  glEnableClientState(GL_VERTEX_ARRAY);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(32, 32, kRed);
}

// 2.8: DrawArrays starts at `first`.
TEST_F(VertexArrays, First) {
  const GLfloat positions[] = {9, 9, 9, 9, -1, -1, 0, -1, -1, 1, 0, 1, 0, -1, 1, -1, 0, 1, 1, 1};
  glColor4f(0, 1, 0, 1);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions);
  glDrawArrays(GL_TRIANGLE_STRIP, 2, 4);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, kBlack);
  glColor4f(1, 0, 0, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 6, 4);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, kRed);
}

// 2.8, 2.9.2: ubyte and ushort indices, from client memory and from a buffer at an offset.
TEST_F(VertexArrays, Indices) {
  // Sixty vertices of which only the last four are the quad.
  std::vector<GLfloat> positions(56 * 2, 5.0f);
  positions.insert(positions.end(), std::begin(kQuad), std::end(kQuad));
  const GLubyte bytes[] = {9, 9, 59, 56, 57, 58, 59};
  const GLushort shorts[] = {9, 59, 56, 57, 58, 59};
  glEnableClientState(GL_VERTEX_ARRAY);
  glColor4f(0, 1, 0, 1);
  Cells cells;
  GLuint buffers[2];
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * 4), positions.data(),
               GL_STATIC_DRAW);
  for (bool bufferedVertices : {false, true}) {
    glBindBuffer(GL_ARRAY_BUFFER, bufferedVertices ? buffers[0] : 0);
    glVertexPointer(2, GL_FLOAT, 0, bufferedVertices ? nullptr : positions.data());
    for (bool bufferedIndices : {false, true}) {
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, bufferedIndices ? buffers[1] : 0);
      if (bufferedIndices) glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof bytes, bytes, GL_STATIC_DRAW);
      cells.add(fmt::format("ubyte {} {}", bufferedVertices, bufferedIndices), kGreen, [&] {
        glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE,
                       bufferedIndices ? reinterpret_cast<const void*>(3) : bytes + 3);
      });
      if (bufferedIndices) glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof shorts, shorts, GL_STATIC_DRAW);
      cells.add(fmt::format("ushort {} {}", bufferedVertices, bufferedIndices), kGreen, [&] {
        glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT,
                       bufferedIndices ? reinterpret_cast<const void*>(4) : shorts + 2);
      });
    }
  }
}

// 2.8: index 65535 is a vertex like any other; ES 1.1 has no primitive restart.
TEST_F(VertexArrays, LargestIndices) {
  std::vector<GLfloat> positions(65536 * 2, 5.0f);
  for (std::size_t i = 0; i < 8; ++i) positions[65532 * 2 + i] = positions[252 * 2 + i] = kQuad[i];
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions.data());
  const GLushort shorts[] = {65532, 65533, 65534, 65535};
  glColor4f(0, 1, 0, 1);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, shorts);
  EXPECT_PIXEL(50, 50, kGreen);
  const GLubyte bytes[] = {252, 253, 254, 255};
  glColor4f(1, 0, 0, 1);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, bytes);
  EXPECT_PIXEL(50, 50, kRed);
}

// 2.1: data are interpreted when the command is called; later changes have no effect.
TEST_F(VertexArrays, ClientMemoryIsReadAtTheCall) {
  GLfloat positions[8], colors[16];
  std::copy(std::begin(kQuad), std::end(kQuad), std::begin(positions));
  GLubyte indices[] = {0, 1, 2, 3};
  for (int i = 0; i < 16; ++i) colors[i] = i % 4 == 1 || i % 4 == 3 ? 1.0f : 0.0f;
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions);
  glColorPointer(4, GL_FLOAT, 0, colors);
  glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, indices);
  std::fill(std::begin(positions), std::end(positions), 0.0f);
  std::fill(std::begin(colors), std::end(colors), 0.5f);
  std::fill(std::begin(indices), std::end(indices), GLubyte{200});
  EXPECT_PIXEL(32, 32, kGreen);
}

// 2.1, 2.9: a buffer changed, respecified or deleted after a draw; the draw has used what was in it.
TEST_F(VertexArrays, BufferChangedWhileInUse) {
  const auto colors = [](GLubyte r, GLubyte g) {
    std::array<GLubyte, 16> result;
    for (std::size_t i = 0; i < 16; i += 4) {
      result[i] = r;
      result[i + 1] = g;
      result[i + 2] = 0;
      result[i + 3] = 255;
    }
    return result;
  };
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 16, colors(0, 255).data(), GL_DYNAMIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glVertexPointer(2, GL_FLOAT, 0, kQuad);
  const auto drawAt = [&](int x) {
    glViewport(x, 0, 16, 64);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  };
  drawAt(0);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferSubData(GL_ARRAY_BUFFER, 0, 16, colors(255, 0).data());
  drawAt(16);
  glBufferData(GL_ARRAY_BUFFER, 16, colors(255, 255).data(), GL_STATIC_DRAW);
  drawAt(32);
  // Only the second half of the rows changes.
  glBufferSubData(GL_ARRAY_BUFFER, 8, 8, colors(0, 0).data());
  drawAt(48);
  glDisableClientState(GL_COLOR_ARRAY);
  glDeleteBuffers(1, &buffer);
  EXPECT_PIXEL(8, 32, kGreen);
  EXPECT_PIXEL(24, 32, kRed);
  EXPECT_PIXEL(40, 32, {1, 1, 0, 1});
  EXPECT_PIXEL(56, 0, {127 / 128.0, 127 / 128.0, 0, 1});
  EXPECT_PIXEL(56, 63, {1 / 128.0, 1 / 128.0, 0, 1});
}

// 2.9: many small updates between draws.
TEST_F(VertexArrays, ManyUpdatesBetweenDraws) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 32, nullptr, GL_DYNAMIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glColor4f(0, 1, 0, 1);
  for (int i = 0; i < 256; ++i) {
    const float x0 = static_cast<float>(i % 16) / 8 - 1, y0 = static_cast<float>(i / 16) / 8 - 1,
                d = 1.0f / 8;
    const GLfloat corners[] = {x0, y0, x0 + d, y0, x0, y0 + d, x0 + d, y0 + d};
    glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof corners, corners);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  const Image image = readAll();
  int missing = 0;
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) missing += !near(image.at(x, y), kGreen);
  }
  EXPECT_EQ(missing, 0);
}

// 2.9: a bound name that is deleted reverts to 0, and the arrays that used it go on without crashing.
TEST_F(VertexArrays, DeletedBuffer) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  GLint binding = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BUFFER_BINDING, &binding);
  EXPECT_EQ(binding, static_cast<GLint>(buffer));
  glDeleteBuffers(1, &buffer);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &binding);
  EXPECT_EQ(binding, 0);
  EXPECT_FALSE(glIsBuffer(buffer));
}

// 2.9: BufferData with size 0 and a null pointer, then data, then a smaller size.
TEST_F(VertexArrays, BufferRespecified) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STATIC_DRAW);
  glBufferData(GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 64, sizeof kQuad, kQuad);
  glBufferSubData(GL_ARRAY_BUFFER, 4096, 0, kQuad);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, reinterpret_cast<const void*>(64));
  glColor4f(0, 1, 0, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(32, 32, kGreen);
  glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_DYNAMIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glColor4f(1, 0, 0, 1);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(32, 32, kRed);
}

// 2.8: interleaved attributes of different types in one buffer.
TEST_F(VertexArrays, Interleaved) {
  struct Vertex {
    GLshort x, y;
    GLubyte color[4];
    GLfixed s, t;
  };
  const Vertex vertices[] = {{-1, -1, {0, 255, 0, 255}, 0, 0},
                             {1, -1, {0, 255, 0, 255}, 65536, 0},
                             {-1, 1, {0, 255, 0, 255}, 0, 65536},
                             {1, 1, {0, 255, 0, 255}, 65536, 65536}};
  const GLubyte texels[] = {255, 255, 255, 255, 255, 0, 255, 255};
  GLuint texture = 0, buffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  useNearest();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glEnable(GL_TEXTURE_2D);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(2, GL_SHORT, sizeof(Vertex), nullptr);
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, color)));
  glTexCoordPointer(2, GL_FIXED, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, s)));
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(16, 32, kGreen);
  EXPECT_PIXEL(48, 32, {0, 0, 0, 1});
}

}  // namespace
}  // namespace conformance
