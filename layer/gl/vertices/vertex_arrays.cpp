// Section 2.8: where arrays lie and which are enabled.
#include "layer/gl/vertices/vertex_arrays.h"

#include "layer/gl/context/params.h"
#include "layer/gl/vertices/buffer.h"

namespace anteroom::gl {

uint32_t bytesOf(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
      return 2;
    default:
      return 4;
  }
}

bool attributeOf(const Context& c, GLenum array, gen::Attribute& attribute) {
  switch (array) {
    case GL_VERTEX_ARRAY:
      attribute = gen::kPosition;
      return true;
    case GL_NORMAL_ARRAY:
      attribute = gen::kNormal;
      return true;
    case GL_COLOR_ARRAY:
      attribute = gen::kColor;
      return true;
    case GL_POINT_SIZE_ARRAY_OES:
      attribute = gen::kPointSize;
      return true;
    case GL_MATRIX_INDEX_ARRAY_OES:
      attribute = gen::kMatrixIndex;
      return true;
    case GL_WEIGHT_ARRAY_OES:
      attribute = gen::kWeight;
      return true;
    case GL_TEXTURE_COORD_ARRAY:
      attribute = gen::texCoord(c.clientActiveTexture);
      return true;
    default:
      return false;
  }
}

// An array without memory to read from counts as disabled.
void syncArray(Context& c, size_t index) {
  const ClientArray& array = c.vertexArrays.arrays[index];
  gen::AttributeState& attribute = c.state.fixed.attributes[index];
  render::VertexArray& source = c.state.arrays[index];

  render::Buffer* buffer = array.buffer ? array.buffer->store.get() : nullptr;
  const bool readable = array.enabled && (array.isOffset ? buffer != nullptr : array.pointer != nullptr);
  if (!readable) {
    c.set(attribute.array, false, gen::kGroupArrays);
    return;
  }
  const uint32_t stride = array.stride ? static_cast<uint32_t>(array.stride)
                                       : static_cast<uint32_t>(array.size) * bytesOf(array.type);
  c.set(attribute.array, true, gen::kGroupArrays);
  c.set(attribute.size, static_cast<uint8_t>(array.size), gen::kGroupArrays);
  c.set(attribute.type, array.type, gen::kGroupArrays);
  c.set(source.buffer, buffer, gen::kGroupArrays);
  c.set(source.pointer, array.pointer, gen::kGroupArrays);
  c.set(source.stride, stride, gen::kGroupArrays);
}

void syncArrays(Context& c) {
  for (size_t index = 0; index < c.vertexArrays.arrays.size(); ++index) syncArray(c, index);
}

namespace {

enum Types : unsigned { kByte = 1, kUnsignedByte = 2, kShort = 4, kFixed = 8, kFloat = 16 };

unsigned typeBit(GLenum type) {
  switch (type) {
    case GL_BYTE:
      return kByte;
    case GL_UNSIGNED_BYTE:
      return kUnsignedByte;
    case GL_SHORT:
      return kShort;
    case GL_FIXED:
      return kFixed;
    case GL_FLOAT:
      return kFloat;
    default:
      return 0;
  }
}

struct Allowed {
  GLint sizeMin, sizeMax;
  unsigned types;
};

// Table 2.4, and OES_matrix_palette's addition to it.
constexpr Allowed kVertex{2, 4, kByte | kShort | kFixed | kFloat};
constexpr Allowed kNormals{3, 3, kByte | kShort | kFixed | kFloat};
constexpr Allowed kColors{4, 4, kUnsignedByte | kFixed | kFloat};
constexpr Allowed kPointSizes{1, 1, kFixed | kFloat};
constexpr Allowed kMatrixIndices{1, gen::kMaxVertexUnits, kUnsignedByte};
constexpr Allowed kWeights{1, gen::kMaxVertexUnits, kFixed | kFloat};

void specify(Context& c, size_t index, const Allowed& allowed, GLint size, GLenum type, GLsizei stride,
             const void* pointer, const char* command = __builtin_FUNCTION()) {
  if (size < allowed.sizeMin || size > allowed.sizeMax)
    return c.setError(
        GL_INVALID_VALUE,
        wrongNumber("size", size,
                    "Give a size of table 2.4: colors have 4, positions and texture coordinates 2 to 4"),
        command);
  if (!(typeBit(type) & allowed.types))
    return c.setError(GL_INVALID_ENUM,
                      wrongEnum("type", type, "Use a type of table 2.4, such as FLOAT or FIXED"), command);
  if (stride < 0)
    return c.setError(GL_INVALID_VALUE,
                      wrongNumber("stride", stride,
                                  "Give the bytes from one element to the next, or 0 when they are packed"),
                      command);
  // OES_vertex_array_object: its objects hold no client memory.
  if (c.boundVertexArray->name != 0 && !c.arrayBuffer && pointer)
    return c.setError(
        GL_INVALID_OPERATION,
        wrongState("A vertex array object is bound and no buffer: objects hold no client memory",
                   "Bind a buffer to ARRAY_BUFFER, or vertex array object 0"),
        command);
  ClientArray& array = c.vertexArrays.arrays[index];
  array.size = size;
  array.type = type;
  array.stride = stride;
  array.pointer = pointer;
  array.isOffset = c.arrayBuffer != nullptr;
  if (array.buffer != c.arrayBuffer) array.buffer = c.arrayBuffer;
  if (!array.enabled) return;
  const ShareLock lock(*c.group);
  syncArray(c, index);
}

void enableArray(GLenum name, bool enable, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  gen::Attribute attribute;
  if (!attributeOf(*c, name, attribute))
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("array", name, "Use VERTEX_ARRAY, COLOR_ARRAY or another ..._ARRAY"),
                       command);
  ClientArray& array = c->vertexArrays.arrays[attribute];
  if (array.enabled == enable) return;
  array.enabled = enable;
  const ShareLock lock(*c->group);
  syncArray(*c, attribute);
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;
namespace gen = anteroom::gen;

GL_API void GL_APIENTRY glVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (Context* c = current()) specify(*c, gen::kPosition, kVertex, size, type, stride, pointer);
}

GL_API void GL_APIENTRY glNormalPointer(GLenum type, GLsizei stride, const void* pointer) {
  if (Context* c = current()) specify(*c, gen::kNormal, kNormals, 3, type, stride, pointer);
}

GL_API void GL_APIENTRY glColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (Context* c = current()) specify(*c, gen::kColor, kColors, size, type, stride, pointer);
}

GL_API void GL_APIENTRY glPointSizePointerOES(GLenum type, GLsizei stride, const void* pointer) {
  if (Context* c = current()) specify(*c, gen::kPointSize, kPointSizes, 1, type, stride, pointer);
}

GL_API void GL_APIENTRY glMatrixIndexPointerOES(GLint size, GLenum type, GLsizei stride,
                                                const void* pointer) {
  if (Context* c = current()) specify(*c, gen::kMatrixIndex, kMatrixIndices, size, type, stride, pointer);
}

GL_API void GL_APIENTRY glWeightPointerOES(GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (Context* c = current()) specify(*c, gen::kWeight, kWeights, size, type, stride, pointer);
}

GL_API void GL_APIENTRY glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
  if (Context* c = current()) {
    specify(*c, gen::texCoord(c->clientActiveTexture), kVertex, size, type, stride, pointer);
  }
}

GL_API void GL_APIENTRY glEnableClientState(GLenum array) {
  enableArray(array, true);
}
GL_API void GL_APIENTRY glDisableClientState(GLenum array) {
  enableArray(array, false);
}

GL_API void GL_APIENTRY glClientActiveTexture(GLenum texture) {
  Context* c = current();
  if (!c) return;
  const int unit = unitOf(*c, "texture", texture);
  if (unit >= 0) c->clientActiveTexture = unit;
}
