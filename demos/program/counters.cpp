// The linker sends the program's calls of these commands here first (--wrap), whichever library they are for.
#include "counters.h"

#include <GLES/gl.h>

namespace program {
namespace {

Counters counters;

// Of what the demos upload: unsigned bytes.
std::uint64_t texelBytes(GLenum format) {
  switch (format) {
    case GL_RGBA:
      return 4;
    case GL_RGB:
      return 3;
    case GL_LUMINANCE_ALPHA:
      return 2;
    default:
      return 1;
  }
}

void countUpload(std::uint64_t bytes) {
  ++counters.uploads;
  counters.uploadedBytes += bytes;
}

void countTexels(GLsizei width, GLsizei height, GLenum format, const void* pixels) {
  if (pixels != nullptr)
    countUpload(static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * texelBytes(format));
}

void countDraw(GLsizei vertices) {
  ++counters.draws;
  counters.vertices += static_cast<std::uint64_t>(vertices);
}

}  // namespace

const Counters& counted() {
  return counters;
}

Counters operator-(const Counters& a, const Counters& b) {
  return {a.draws - b.draws,
          a.vertices - b.vertices,
          a.clears - b.clears,
          a.textureBinds - b.textureBinds,
          a.matrixLoads - b.matrixLoads,
          a.uploads - b.uploads,
          a.uploadedBytes - b.uploadedBytes};
}

}  // namespace program

using namespace program;

extern "C" {

void __real_glDrawArrays(GLenum mode, GLint first, GLsizei count);
void __real_glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices);
void __real_glClear(GLbitfield mask);
void __real_glBindTexture(GLenum target, GLuint texture);
void __real_glLoadMatrixf(const GLfloat* m);
void __real_glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage);
void __real_glTexImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                         GLint border, GLenum format, GLenum type, const void* pixels);

void __wrap_glDrawArrays(GLenum mode, GLint first, GLsizei count) {
  countDraw(count);
  __real_glDrawArrays(mode, first, count);
}

void __wrap_glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  countDraw(count);
  __real_glDrawElements(mode, count, type, indices);
}

void __wrap_glClear(GLbitfield mask) {
  ++counters.clears;
  __real_glClear(mask);
}

void __wrap_glBindTexture(GLenum target, GLuint texture) {
  ++counters.textureBinds;
  __real_glBindTexture(target, texture);
}

void __wrap_glLoadMatrixf(const GLfloat* m) {
  ++counters.matrixLoads;
  __real_glLoadMatrixf(m);
}

void __wrap_glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  if (data != nullptr) countUpload(static_cast<std::uint64_t>(size));
  __real_glBufferData(target, size, data, usage);
}

void __wrap_glTexImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                         GLint border, GLenum format, GLenum type, const void* pixels) {
  countTexels(width, height, format, pixels);
  __real_glTexImage2D(target, level, internalFormat, width, height, border, format, type, pixels);
}

}  // extern "C"
