#include "tests/reference/primitives.h"

#include <cstring>

namespace anteroom::reference {

namespace {

template <typename T>
void readIndices(const std::byte* from, size_t available, std::vector<int64_t>& result) {
  for (size_t i = 0; i < result.size(); ++i) {
    if ((i + 1) * sizeof(T) > available) {
      result.resize(i);
      return;
    }
    T index;
    std::memcpy(&index, from + i * sizeof(T), sizeof index);
    result[i] = index;
  }
}

}  // namespace

std::vector<int64_t> elements(const render::DrawCall& call) {
  std::vector<int64_t> result(static_cast<size_t>(call.count));
  if (call.indexType == 0) {
    for (size_t i = 0; i < result.size(); ++i) result[i] = call.first + static_cast<int64_t>(i);
    return result;
  }
  const std::byte* from = static_cast<const std::byte*>(call.indices);
  size_t available = SIZE_MAX;
  if (call.indexBuffer != nullptr) {
    const size_t offset = reinterpret_cast<uintptr_t>(call.indices);
    available = offset < call.indexBuffer->size() ? call.indexBuffer->size() - offset : 0;
    from = call.indexBuffer->contents() + (available != 0 ? offset : 0);
  }
  switch (call.indexType) {
    case GL_UNSIGNED_BYTE:
      readIndices<uint8_t>(from, available, result);
      break;
    case GL_UNSIGNED_SHORT:
      readIndices<uint16_t>(from, available, result);
      break;
    default:
      readIndices<uint32_t>(from, available, result);
  }
  return result;
}

void assemble(GLenum mode, size_t count, const std::function<void(const std::vector<size_t>&)>& emit) {
  switch (mode) {
    case GL_POINTS:
      for (size_t i = 0; i < count; ++i) emit({i});
      break;
    case GL_LINES:
      for (size_t i = 0; i + 1 < count; i += 2) emit({i, i + 1});
      break;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
      for (size_t i = 0; i + 1 < count; ++i) emit({i, i + 1});
      if (mode == GL_LINE_LOOP && count > 1) emit({count - 1, 0});
      break;
    case GL_TRIANGLES:
      for (size_t i = 0; i + 2 < count; i += 3) emit({i, i + 1, i + 2});
      break;
    case GL_TRIANGLE_STRIP:
      for (size_t i = 0; i + 2 < count; ++i) {
        if (i % 2 == 0)
          emit({i, i + 1, i + 2});
        else
          emit({i + 1, i, i + 2});
      }
      break;
    case GL_TRIANGLE_FAN:
      for (size_t i = 0; i + 2 < count; ++i) emit({0, i + 1, i + 2});
      break;
    default:
      break;
  }
}

}  // namespace anteroom::reference
