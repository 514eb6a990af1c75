// Names that a program gives its objects (KHR_debug section 5.5.8, EXT_debug_label). Those of images go on to
// the device, for tools that look there; buffers are pieces of larger ones there.
#include <algorithm>
#include <cstring>
#include <new>

#include "layer/gl/context/fences.h"
#include "layer/gl/debug/debug_output.h"
#include "layer/gl/debug/tool_names.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/vertices/buffer.h"

namespace anteroom::gl {
namespace {

// The label of an object. known: there are objects of this type; label null: none has this name.
struct Labelled {
  bool known = true;
  std::string* label = nullptr;
  std::shared_ptr<void> object;  // keeps it alive
};

template <class T>
Labelled labelled(const std::shared_ptr<T>& object) {
  return {true, object ? &object->label : nullptr, object};
}

Labelled find(Context& c, GLenum type, GLuint name) {
  switch (type) {
    case GL_BUFFER_KHR:
    case GL_BUFFER_OBJECT_EXT:
      return labelled(c.group->buffers.find(name));
    case GL_TEXTURE:
      return labelled(c.group->textures.find(name));
    case GL_FRAMEBUFFER_OES:
      return labelled(c.group->framebuffers.find(name));
    case GL_RENDERBUFFER_OES:
      return labelled(c.group->renderbuffers.find(name));
    case GL_VERTEX_ARRAY_KHR:
    case GL_VERTEX_ARRAY_OBJECT_EXT:
      return labelled(c.vertexArrayObjects.find(name));
    case GL_SYNC_OBJECT_APPLE:
      return labelled(c.group->syncs.find(name));
    default:
      return {false, nullptr, nullptr};
  }
}

void tellDevice(Context& c, GLenum type, GLuint name, const std::string& label) {
  if (type == GL_TEXTURE) {
    c.group->textures.find(name)->labelChanged(c);
  } else if (type == GL_RENDERBUFFER_OES) {
    if (const auto& image = c.group->renderbuffers.find(name)->image)
      nameImage(c, *image, "renderbuffer", name, label);
  }
}

// In which the two extensions differ.
struct Dialect {
  GLenum noObject;  // the error
  bool ext;
  bool pointer = false;  // ObjectPtrLabel, of sync objects alone
};
constexpr Dialect kKhr{GL_INVALID_VALUE, false}, kExt{GL_INVALID_OPERATION, true},
    kKhrPointer{GL_INVALID_VALUE, false, true};

// KHR_debug and EXT_debug_label call some types differently: each takes its own names.
bool isTypeOf(Dialect dialect, GLenum type) {
  if (type == GL_BUFFER_KHR || type == GL_VERTEX_ARRAY_KHR) return !dialect.ext;
  if (type == GL_BUFFER_OBJECT_EXT || type == GL_VERTEX_ARRAY_OBJECT_EXT) return dialect.ext;
  return type != GL_SYNC_OBJECT_APPLE || dialect.ext || dialect.pointer;
}

// Null label: the error is set.
Labelled findFor(Context& c, Dialect dialect, GLenum type, GLuint name, const char* command) {
  Labelled found = isTypeOf(dialect, type) ? find(c, type, name) : Labelled{false, nullptr, nullptr};
  if (!found.known)
    c.setError(GL_INVALID_ENUM,
               wrongEnum(dialect.ext ? "type" : "identifier", type,
                         dialect.ext ? "Use TEXTURE, FRAMEBUFFER_OES, RENDERBUFFER_OES, BUFFER_OBJECT_EXT, "
                                       "VERTEX_ARRAY_OBJECT_EXT or SYNC_OBJECT_APPLE"
                                     : "Use TEXTURE, FRAMEBUFFER_OES, RENDERBUFFER_OES, BUFFER_KHR or "
                                       "VERTEX_ARRAY_KHR"),
               command);
  else if (!found.label)
    c.setError(dialect.noObject,
               dialect.pointer
                   ? wrongState("ptr is not the name of a sync object",
                                "Label other objects with glObjectLabelKHR and their names")
                   : wrongNumber(dialect.ext ? "object" : "name", name,
                                 "Bind the name first: until then there is no object of this type"),
               command);
  return found;
}

void setLabel(Dialect dialect, GLenum type, GLuint name, GLsizei length, const GLchar* label,
              const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  const Labelled found = findFor(*c, dialect, type, name, command);
  if (!found.label) return;
  if (dialect.ext && length < 0)
    return c->setError(GL_INVALID_VALUE,
                       wrongNumber("length", length, "Give 0 for a string with a null at its end"), command);
  const std::string_view text = textOf(label, dialect.ext && length == 0 ? -1 : length);
  if (!dialect.ext && text.size() >= kMostLabelLength)
    return c->setError(
        GL_INVALID_VALUE,
        wrongNumber("length", text.size(), "Give fewer characters than the value of MAX_LABEL_LENGTH_KHR"),
        command);
  try {
    *found.label = text;
    tellDevice(*c, type, name, *found.label);
  } catch (const std::bad_alloc&) {
    c->setError(GL_OUT_OF_MEMORY, {}, command);
  }
}

// `out` null: only the length is wanted.
void putLabel(const std::string& label, GLsizei bufSize, GLsizei* length, GLchar* out) {
  size_t size = label.size();
  if (out) {
    if (bufSize <= 0) {
      size = 0;
    } else {
      size = std::min(size, static_cast<size_t>(bufSize) - 1);
      std::memcpy(out, label.data(), size);
      out[size] = 0;
    }
  }
  if (length) *length = static_cast<GLsizei>(size);
}

void getLabel(Dialect dialect, GLenum type, GLuint name, GLsizei bufSize, GLsizei* length, GLchar* label,
              const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  const Labelled found = findFor(*c, dialect, type, name, command);
  if (!found.label) return;
  if (bufSize < 0)
    return c->setError(GL_INVALID_VALUE, wrongNumber("bufSize", bufSize, "Give the size of label in bytes"),
                       command);
  putLabel(*found.label, bufSize, length, label);
}

}  // namespace
}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glObjectLabelKHR(GLenum identifier, GLuint name, GLsizei length,
                                         const GLchar* label) {
  setLabel(kKhr, identifier, name, length, label);
}

GL_API void GL_APIENTRY glGetObjectLabelKHR(GLenum identifier, GLuint name, GLsizei bufSize, GLsizei* length,
                                            GLchar* label) {
  getLabel(kKhr, identifier, name, bufSize, length, label);
}

GL_API void GL_APIENTRY glObjectPtrLabelKHR(const void* ptr, GLsizei length, const GLchar* label) {
  setLabel(kKhrPointer, GL_SYNC_OBJECT_APPLE, syncName(ptr), length, label);
}

GL_API void GL_APIENTRY glGetObjectPtrLabelKHR(const void* ptr, GLsizei bufSize, GLsizei* length,
                                               GLchar* label) {
  getLabel(kKhrPointer, GL_SYNC_OBJECT_APPLE, syncName(ptr), bufSize, length, label);
}

GL_API void GL_APIENTRY glLabelObjectEXT(GLenum type, GLuint object, GLsizei length, const GLchar* label) {
  setLabel(kExt, type, object, length, label);
}

GL_API void GL_APIENTRY glGetObjectLabelEXT(GLenum type, GLuint object, GLsizei bufSize, GLsizei* length,
                                            GLchar* label) {
  getLabel(kExt, type, object, bufSize, length, label);
}
