#include "layer/gl/debug/tool_names.h"

#include <array>
#include <cstdio>
#include <new>
#include <string_view>

#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/vertices/buffer.h"

namespace anteroom::gl {
namespace {

constexpr const char* kModes[] = {"GL_POINTS",    "GL_LINES",          "GL_LINE_LOOP",   "GL_LINE_STRIP",
                                  "GL_TRIANGLES", "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN"};

const char* nameOfIndexType(GLenum type) {
  return type == GL_UNSIGNED_BYTE    ? "GL_UNSIGNED_BYTE"
         : type == GL_UNSIGNED_SHORT ? "GL_UNSIGNED_SHORT"
                                     : "GL_UNSIGNED_INT";
}

std::string nameOfArray(int attribute) {
  constexpr const char* kNames[] = {"position", "normal", "color", "pointSize"};
  if (attribute < gen::kTexCoord0) return kNames[attribute];
  if (attribute <= gen::kTexCoordLast) return "texCoord" + std::to_string(attribute - gen::kTexCoord0);
  return attribute == gen::kMatrixIndex ? "matrixIndex" : "weight";
}

std::string nameOfBuffer(const BufferObject* buffer) {
  return buffer ? nameOf("buffer", buffer->name, buffer->label) : "client memory";
}

std::string describeCall(const char* command, const render::DrawCall& call) {
  std::string text = std::string(command) + "(" + kModes[call.mode];
  if (!call.indexType)
    return text + ", " + std::to_string(call.first) + ", " + std::to_string(call.count) + ")";
  char indices[24];
  std::snprintf(indices, sizeof indices, call.indexBuffer ? "%zu" : "0x%zx",
                reinterpret_cast<size_t>(call.indices));
  return text + ", " + std::to_string(call.count) + ", " + nameOfIndexType(call.indexType) + ", " + indices +
         ")";
}

std::string describeTextures(const Context& c) {
  std::string text;
  for (size_t unit = 0; unit < c.units.size(); ++unit) {
    const UnitBindings& bindings = c.units[unit];
    if (bindings.sampled == kSlotCount) continue;
    const Texture& texture = *bindings.bound[bindings.sampled];
    text += text.empty() ? "" : ", ";
    text += "texture" + std::to_string(unit) + " " + nameOf("texture", texture.name, texture.label);
  }
  return text;
}

// Consecutive arrays in one buffer name it once.
std::string describeArrays(const Context& c, const render::DrawCall& call) {
  std::string text, former;
  for (int a = 0; a < gen::kAttributeCount; ++a) {
    if (!c.state.fixed.attributes[static_cast<size_t>(a)].array) continue;
    const std::string place = nameOfBuffer(c.vertexArrays.arrays[static_cast<size_t>(a)].buffer.get());
    if (!text.empty()) text += place == former ? ", " : " in " + former + ", ";
    text += nameOfArray(a);
    former = place;
  }
  if (!text.empty()) text += " in " + former;
  if (call.indexType) text += ", indices in " + nameOfBuffer(c.vertexArrays.elementBuffer.get());
  return text;
}

std::string describeFramebuffer(const Context& c) {
  if (!c.boundFramebuffer) return {};
  return nameOf("framebuffer", c.boundFramebuffer->name, c.boundFramebuffer->label);
}

std::string joined(std::string text, std::initializer_list<std::string> parts) {
  const char* separator = ": ";
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    text += separator + part;
    separator = "; ";
  }
  return text;
}

}  // namespace

std::string nameOf(const char* kind, GLuint name, const std::string& label) {
  std::string text = std::string(kind) + " " + std::to_string(name);
  return label.empty() ? text : label + " (" + text + ")";
}

void nameImage(const Context& c, render::Image& image, const char* kind, GLuint name,
               const std::string& label) {
  if (c.device.caps().objectNames)
    image.setLabel(nameOf(kind, name, label));
  else if (!label.empty())
    image.setLabel(label);
}

CommandGroup::CommandGroup(Context& c, const char* command, const render::DrawCall& call)
    : renderer_(*c.renderer) {
  try {
    // The rectangles of OES_draw_texture have no arrays of the program's.
    const bool rectangle = std::string_view(command).starts_with("glDrawTex");
    open(joined(rectangle ? command : describeCall(command, call),
                {describeTextures(c), rectangle ? "" : describeArrays(c, call), describeFramebuffer(c)}));
  } catch (const std::bad_alloc&) {
    // A group is not worth an error.
  }
}

CommandGroup::CommandGroup(Context& c, const char* command, GLbitfield mask) : renderer_(*c.renderer) {
  try {
    constexpr std::pair<GLbitfield, const char*> kBits[] = {{GL_COLOR_BUFFER_BIT, "GL_COLOR_BUFFER_BIT"},
                                                            {GL_DEPTH_BUFFER_BIT, "GL_DEPTH_BUFFER_BIT"},
                                                            {GL_STENCIL_BUFFER_BIT, "GL_STENCIL_BUFFER_BIT"}};
    std::string bits;
    for (const auto& [bit, name] : kBits)
      if (mask & bit) bits.append(bits.empty() ? "" : " | ").append(name);
    open(joined(std::string(command) + "(" + bits + ")", {describeFramebuffer(c)}));
  } catch (const std::bad_alloc&) {
    // A group is not worth an error.
  }
}

void CommandGroup::open(const std::string& text) {
  renderer_.pushGroup(text);
  open_ = true;
}

CommandGroup::~CommandGroup() {
  if (open_) renderer_.popGroup();
}

}  // namespace anteroom::gl
