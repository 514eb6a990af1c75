// OES_matrix_palette and OES_extended_matrix_palette: state, errors, matrices and arrays.
#include <fmt/format.h>

#include "palette_fixture.h"
#include "state_snapshot.h"

namespace conformance {
namespace {

class MatrixPalette : public PaletteFixture {};

const void* getPointer(GLenum name) {
  void* pointer = nullptr;
  glGetPointerv(name, &pointer);
  return pointer;
}

// New state: tables 6.6, 6.7 and 6.9; the extended extension's minima.
TEST_F(MatrixPalette, InitialState) {
  EXPECT_EQ(get(GL_MAX_PALETTE_MATRICES_OES), 64);
  EXPECT_EQ(get(GL_MAX_VERTEX_UNITS_OES), 4);
  EXPECT_EQ(get(GL_CURRENT_PALETTE_MATRIX_OES), 0);
  for (GLenum name : {GL_MATRIX_PALETTE_OES, GL_MATRIX_INDEX_ARRAY_OES, GL_WEIGHT_ARRAY_OES})
    EXPECT_FALSE(glIsEnabled(static_cast<GLenum>(name)));
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_SIZE_OES), 0);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_TYPE_OES), GL_UNSIGNED_BYTE);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_STRIDE_OES), 0);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES), 0);
  EXPECT_EQ(getPointer(GL_MATRIX_INDEX_ARRAY_POINTER_OES), nullptr);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_SIZE_OES), 0);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_TYPE_OES), GL_FLOAT);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_STRIDE_OES), 0);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_BUFFER_BINDING_OES), 0);
  EXPECT_EQ(getPointer(GL_WEIGHT_ARRAY_POINTER_OES), nullptr);
  EXPECT_GE(get(GL_MAX_MODELVIEW_STACK_DEPTH), 32) << "the text wants so many";
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  for (GLuint i = 0; i < 64; ++i) {
    currentPaletteMatrix(i);
    EXPECT_EQ(current().m, Mat4{}.m) << i;
  }
}

TEST_F(MatrixPalette, ArraysAsSet) {
  GLuint buffers[2] = {};
  glGenBuffers(2, buffers);
  for (GLuint name : buffers) {
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  matrixIndexPointer(3, GL_UNSIGNED_BYTE, 7, reinterpret_cast<const void*>(5));
  glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  weightPointer(2, GL_FIXED, 12, reinterpret_cast<const void*>(8));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glEnableClientState(GL_WEIGHT_ARRAY_OES);
  glEnable(GL_MATRIX_PALETTE_OES);
  EXPECT_TRUE(glIsEnabled(GL_MATRIX_PALETTE_OES));
  EXPECT_TRUE(glIsEnabled(GL_WEIGHT_ARRAY_OES));
  EXPECT_FALSE(glIsEnabled(GL_MATRIX_INDEX_ARRAY_OES));
  GLboolean enabled = GL_FALSE;
  glGetBooleanv(GL_WEIGHT_ARRAY_OES, &enabled);
  EXPECT_EQ(enabled, GL_TRUE);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_SIZE_OES), 3);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_STRIDE_OES), 7);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES), static_cast<GLint>(buffers[0]));
  EXPECT_EQ(getPointer(GL_MATRIX_INDEX_ARRAY_POINTER_OES), reinterpret_cast<const void*>(5));
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_SIZE_OES), 2);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_TYPE_OES), GL_FIXED);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_STRIDE_OES), 12);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_BUFFER_BINDING_OES), static_cast<GLint>(buffers[1]));
  EXPECT_EQ(getPointer(GL_WEIGHT_ARRAY_POINTER_OES), reinterpret_cast<const void*>(8));
  glDeleteBuffers(2, buffers);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_BUFFER_BINDING_OES), 0);
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_BUFFER_BINDING_OES), 0);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST_F(MatrixPalette, Errors) {
  const GLfloat data[4] = {};
  matrixIndexPointer(2, GL_UNSIGNED_BYTE, 4, data);
  weightPointer(3, GL_FIXED, 8, data);
  currentPaletteMatrix(63);
  const StateSnapshot before = takeSnapshot();
  const auto unchanged = [&](GLenum error, const std::string& what) {
    EXPECT_GL_ERROR(error) << what;
    EXPECT_EQ(difference(before, takeSnapshot()), "") << what;
    EXPECT_EQ(get(GL_CURRENT_PALETTE_MATRIX_OES), 63) << what;
    EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_SIZE_OES), 2) << what;
    EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_TYPE_OES), GL_UNSIGNED_BYTE) << what;
    EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_STRIDE_OES), 4) << what;
    EXPECT_EQ(get(GL_WEIGHT_ARRAY_SIZE_OES), 3) << what;
    EXPECT_EQ(get(GL_WEIGHT_ARRAY_TYPE_OES), GL_FIXED) << what;
    EXPECT_EQ(get(GL_WEIGHT_ARRAY_STRIDE_OES), 8) << what;
  };
  for (GLuint index : {64u, 65u, 255u, 0x80000000u, ~0u}) {
    currentPaletteMatrix(index);
    unchanged(GL_INVALID_VALUE, fmt::format("matrix {}", index));
  }
  for (GLint size : {5, 0, -1, 256}) {
    matrixIndexPointer(size, GL_UNSIGNED_BYTE, 0, data);
    unchanged(GL_INVALID_VALUE, fmt::format("{} indices", size));
    weightPointer(size, GL_FLOAT, 0, data);
    unchanged(GL_INVALID_VALUE, fmt::format("{} weights", size));
  }
  for (GLenum type : {GL_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_FLOAT, GL_FIXED, 0}) {
    matrixIndexPointer(1, static_cast<GLenum>(type), 0, data);
    unchanged(GL_INVALID_ENUM, fmt::format("indices of type {:#x}", type));
  }
  for (GLenum type : {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, 0}) {
    weightPointer(1, static_cast<GLenum>(type), 0, data);
    unchanged(GL_INVALID_ENUM, fmt::format("weights of type {:#x}", type));
  }
  matrixIndexPointer(1, GL_UNSIGNED_BYTE, -1, data);
  unchanged(GL_INVALID_VALUE, "stride");
  weightPointer(1, GL_FLOAT, -1, data);
  unchanged(GL_INVALID_VALUE, "stride");
  // A palette is neither an array nor an array a capability.
  glEnable(GL_WEIGHT_ARRAY_OES);
  unchanged(GL_INVALID_ENUM, "Enable");
  glEnableClientState(GL_MATRIX_PALETTE_OES);
  unchanged(GL_INVALID_ENUM, "EnableClientState");
}

// Every command on matrices goes to the current one of the palette, and to nothing else.
TEST_F(MatrixPalette, MatrixCommands) {
  const Mat4 own = translation(1, 2, 3) * rotation(30, 0, 0, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(floats(own).data());
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  EXPECT_EQ(get(GL_MATRIX_MODE), GL_MATRIX_PALETTE_OES);
  currentPaletteMatrix(7);
  glTranslatef(0.5f, -2, 3);
  glRotatex(90 << 16, 0, 1 << 16, 0);
  glScalef(2, 3, 4);
  glMultMatrixf(floats(rotation(20, 1, 2, 3)).data());
  glFrustumf(-1, 1, -2, 2, 1, 10);
  const Mat4 expected = translation(0.5, -2, 3) * rotation(90, 0, 1, 0) * scaling(2, 3, 4) *
                        rotation(20, 1, 2, 3) * frustum(-1, 1, -2, 2, 1, 10);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(current().m[i], expected.m[i], 1e-5) << i;
  currentPaletteMatrix(8);
  EXPECT_EQ(current().m, Mat4{}.m);
  // A palette has no stack.
  glPushMatrix();
  EXPECT_GL_ERROR(GL_STACK_OVERFLOW);
  glPopMatrix();
  EXPECT_GL_ERROR(GL_STACK_UNDERFLOW);
  EXPECT_EQ(current().m, Mat4{}.m);

  // In any mode.
  glMatrixMode(GL_PROJECTION);
  currentPaletteMatrix(63);
  loadFromModelView();
  EXPECT_EQ(current().m, Mat4{}.m) << "the projection stays";
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(current().m[i], own.m[i], 1e-6) << i;
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(current().m[i], own.m[i], 1e-6) << i;
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// The modelview matrix counts only without the palette.
TEST_F(MatrixPalette, ReplacesTheModelview) {
  glTranslatef(0.5f, 0.5f, 0);
  setMatrix(9, translation(-0.5, -0.25, 0));
  drawChosen({{9, 1}}, kHalf);
  expectRect(-1, -0.75, 0, 0.25, "palette");
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kHalf);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  expectRect(0, 0, 1, 1, "modelview");
}

TEST_F(MatrixPalette, WithoutArraysNothingIsDrawn) {
  const GLubyte indices[4] = {};
  const GLfloat weights[] = {1, 1, 1, 1};
  matrixIndexPointer(1, GL_UNSIGNED_BYTE, 0, indices);
  weightPointer(1, GL_FLOAT, 0, weights);
  glEnable(GL_MATRIX_PALETTE_OES);
  glVertexPointer(2, GL_FLOAT, 0, kFull);
  for (unsigned enabled = 0; enabled < 8; ++enabled) {
    for (unsigned i = 0; i < 3; ++i)
      (enabled >> i & 1 ? glEnableClientState : glDisableClientState)(kArrays[i]);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    const GLubyte order[] = {0, 1, 2, 3};
    glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, order);
    EXPECT_GL_ERROR(GL_NO_ERROR) << enabled;
    EXPECT_PIXEL(32, 32, enabled == 7 ? kGreen : kBlack) << enabled;
  }
  glClear(GL_COLOR_BUFFER_BIT);
  weightPointer(1, GL_FLOAT, 0, nullptr);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_PIXEL(32, 32, kBlack) << "weights without memory";
}

struct Layout {
  std::size_t padding, offset;  // units of the type's size
  bool buffered;
};

std::vector<Layout> layouts() {
  std::vector<Layout> result;
  for (bool buffered : {false, true})
    for (std::size_t padding : {0, 1, 3, 13})
      for (std::size_t offset : {0, 1, 5}) result.push_back({padding, offset, buffered});
  return result;
}

// Elements of `size` values, apart and behind an offset; nothing behind the last may be needed.
template <class T>
std::vector<T> spread(const std::vector<std::vector<T>>& elements, const Layout& layout) {
  std::vector<T> values(layout.offset, T(0x55));
  for (const auto& element : elements) {
    values.insert(values.end(), element.begin(), element.end());
    if (&element != &elements.back()) values.insert(values.end(), layout.padding, T(0x55));
  }
  return values;
}

template <class T, class Set>
void place(const std::vector<T>& values, const Layout& layout, Set set) {
  if (!layout.buffered) return set(values.data() + layout.offset);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
               GL_STATIC_DRAW);
  set(reinterpret_cast<const void*>(layout.offset * sizeof(T)));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

// Every size, type, stride and offset. Each vertex has its own order of indices and weights; only together do
// they leave the quad where it is.
TEST_F(MatrixPalette, ArrayLayouts) {
  constexpr double kMove[] = {-3, 5, 7};
  for (std::size_t size = 1; size <= 4; ++size) {
    // 1/2, 1/4, ..., and what is left.
    std::vector<double> weight(size);
    double left = 1, sum = 0;
    for (std::size_t i = 0; i + 1 < size; ++i) {
      weight[i] = left / 2;
      left -= weight[i];
      sum += weight[i] * kMove[i];
      setMatrix(static_cast<GLuint>(10 + i), translation(kMove[i], -kMove[i], 0));
    }
    weight[size - 1] = left;
    setMatrix(static_cast<GLuint>(10 + size - 1), translation(-sum / left, sum / left, 0));
    std::vector<std::vector<GLubyte>> indices(4);
    std::vector<std::vector<GLfloat>> floatWeights(4);
    std::vector<std::vector<GLfixed>> fixedWeights(4);
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
      for (std::size_t i = 0; i < size; ++i) {
        const std::size_t unit = (i + vertex) % size;
        indices[vertex].push_back(static_cast<GLubyte>(10 + unit));
        floatWeights[vertex].push_back(static_cast<GLfloat>(weight[unit]));
        fixedWeights[vertex].push_back(static_cast<GLfixed>(weight[unit] * 65536));
      }
    }
    const auto setIndices = [&](const Layout& layout, const std::vector<GLubyte>& values) {
      const auto stride = layout.padding ? static_cast<GLsizei>(size + layout.padding) : 0;
      place(values, layout, [&](const void* pointer) {
        matrixIndexPointer(static_cast<GLint>(size), GL_UNSIGNED_BYTE, stride, pointer);
      });
    };
    const auto setWeights = [&](const Layout& layout, GLenum type, const auto& values) {
      const auto stride = layout.padding ? static_cast<GLsizei>(4 * (size + layout.padding)) : 0;
      place(values, layout,
            [&](const void* pointer) { weightPointer(static_cast<GLint>(size), type, stride, pointer); });
    };
    for (const Layout& layout : layouts()) {
      const std::string name = fmt::format("size {} padding {} offset {} {}", size, layout.padding,
                                           layout.offset, layout.buffered ? "buffer" : "client");
      const Layout tight{0, 0, false};
      const auto bytes = spread(indices, layout), tightBytes = spread(indices, tight);
      const auto wide = spread(floatWeights, layout), tightWide = spread(floatWeights, tight);
      const auto fixed = spread(fixedWeights, layout);
      setIndices(layout, bytes);
      setWeights(tight, GL_FLOAT, tightWide);
      drawEnabled(kHalf);
      expectRect(-0.5, -0.5, 0.5, 0.5, "indices: " + name);
      setIndices(tight, tightBytes);
      setWeights(layout, GL_FLOAT, wide);
      drawEnabled(kHalf);
      expectRect(-0.5, -0.5, 0.5, 0.5, "float weights: " + name);
      setIndices(layout, bytes);
      setWeights(layout, GL_FIXED, fixed);
      drawEnabled(kHalf);
      expectRect(-0.5, -0.5, 0.5, 0.5, "fixed weights: " + name);
    }
  }
}

// n is the size of the indices; a weight that is not given counts as 0, one that has no index does not count.
TEST_F(MatrixPalette, SizesThatDiffer) {
  setMatrix(1, translation(0.5, 0, 0));
  setMatrix(2, translation(0, 0.5, 0));
  const std::vector<GLubyte> indices = {1, 2, 1, 2, 1, 2, 1, 2};
  const std::vector<GLfloat> one = {1, 1, 1, 1}, two = {1, 7, 1, 7, 1, 7, 1, 7};
  matrixIndexPointer(2, GL_UNSIGNED_BYTE, 0, indices.data());
  weightPointer(1, GL_FLOAT, 0, one.data());
  drawEnabled(kHalf);
  expectRect(0, -0.5, 1, 0.5, "a weight is missing");
  matrixIndexPointer(1, GL_UNSIGNED_BYTE, 2, indices.data());
  weightPointer(2, GL_FLOAT, 0, two.data());
  drawEnabled(kHalf);
  expectRect(0, -0.5, 1, 0.5, "a weight too many");
}

// Indices that no matrix has read the last one; nothing outside is read.
TEST_F(MatrixPalette, IndicesBeyondThePalette) {
  setMatrix(63, translation(-0.5, 0, 0));
  for (GLubyte index : {63, 64, 65, 128, 255}) {
    drawChosen({{index, 0.5}, {63, 0.5}}, kHalf);
    expectRect(-1, -0.5, 0, 0.5, fmt::format("index {}", index));
  }
}

// Vertex array objects hold both arrays; buffers that are mapped are not drawn from.
TEST_F(MatrixPalette, ArrayAndBufferObjects) {
  NEEDS_EXTENSION("GL_OES_vertex_array_object");
  COMMAND(PFNGLBINDVERTEXARRAYOESPROC, BindVertexArrayOES);
  COMMAND(PFNGLGENVERTEXARRAYSOESPROC, GenVertexArraysOES);
  COMMAND(PFNGLMAPBUFFEROESPROC, MapBufferOES);
  COMMAND(PFNGLUNMAPBUFFEROESPROC, UnmapBufferOES);
  struct {
    GLfloat corners[8];
    GLfloat weights[4] = {1, 1, 1, 1};
    GLubyte indices[4] = {30, 30, 30, 30};
  } data;
  std::copy_n(kHalf, 8, data.corners);
  GLuint object = 0, buffer = 0;
  GenVertexArraysOES(1, &object);
  BindVertexArrayOES(object);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_SIZE_OES), 0);
  EXPECT_EQ(get(GL_MATRIX_INDEX_ARRAY_TYPE_OES), GL_UNSIGNED_BYTE);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof data, &data, GL_STATIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  weightPointer(1, GL_FLOAT, 0, reinterpret_cast<const void*>(sizeof data.corners));
  matrixIndexPointer(1, GL_UNSIGNED_BYTE, 0,
                     reinterpret_cast<const void*>(sizeof data.corners + sizeof data.weights));
  for (GLenum array : kArrays) glEnableClientState(array);
  BindVertexArrayOES(0);
  EXPECT_FALSE(glIsEnabled(GL_WEIGHT_ARRAY_OES));
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_SIZE_OES), 0);
  setMatrix(30, translation(0, 0.5, 0));
  glEnable(GL_MATRIX_PALETTE_OES);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  expectRect(0, 0, 0, 0, "no arrays");
  BindVertexArrayOES(object);
  EXPECT_TRUE(glIsEnabled(GL_WEIGHT_ARRAY_OES));
  EXPECT_EQ(get(GL_WEIGHT_ARRAY_BUFFER_BINDING_OES), static_cast<GLint>(buffer));
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  expectRect(-0.5, 0, 0.5, 1, "from the object");

  GLubyte client[4] = {};
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  matrixIndexPointer(1, GL_UNSIGNED_BYTE, 0, client);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION) << "an object holds no client memory";
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  ASSERT_NE(MapBufferOES(GL_ARRAY_BUFFER, GL_WRITE_ONLY_OES), nullptr);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  EXPECT_TRUE(UnmapBufferOES(GL_ARRAY_BUFFER));
}

// An array that ends too early gives that primitive anything, and harms nothing else.
TEST_F(MatrixPalette, ShortBuffers) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  const GLubyte bytes[3] = {1, 2, 3};
  glBufferData(GL_ARRAY_BUFFER, sizeof bytes, bytes, GL_STATIC_DRAW);
  matrixIndexPointer(4, GL_UNSIGNED_BYTE, 0, nullptr);
  weightPointer(4, GL_FLOAT, 0, reinterpret_cast<const void*>(1));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  drawEnabled(kFull);
  glClear(GL_COLOR_BUFFER_BIT);
  drawChosen({{0, 1}});
  EXPECT_PIXEL(32, 32, kGreen);
}

}  // namespace
}  // namespace conformance
