// Section 6.1.5: GetString, and the table of what the layer offers beyond the core.
#include <algorithm>
#include <string>
#include <string_view>

#include "layer/gl/context/context.h"

using namespace anteroom::gl;

namespace render = anteroom::render;

namespace {

constexpr std::string_view kExtensions[] = {
#define ANTEROOM_EXTENSION(name, purpose) "GL_" #name,
#include "layer/gl/extensions.inc"
#undef ANTEROOM_EXTENSION
};
static_assert(std::ranges::is_sorted(kExtensions));

// What some devices lack.
bool offered(const render::Caps& caps, std::string_view name) {
  if (name == "GL_OES_depth32") return caps.renderable[static_cast<int>(render::Format::Depth32)];
  if (name == "GL_EXT_texture_filter_anisotropic") return caps.maxAnisotropy >= 2;
  if (name == "GL_EXT_polygon_offset_clamp") return caps.polygonOffsetClamp;
  if (name.find("multisample") != name.npos) return caps.maxSamples > 1;
  return true;
}

std::string join(const render::Caps& caps) {
  std::string joined;
  for (std::string_view name : kExtensions) {
    if (!offered(caps, name)) continue;
    if (!joined.empty()) joined += ' ';
    joined += name;
  }
  return joined;
}

}  // namespace

GL_API const GLubyte* GL_APIENTRY glGetString(GLenum name) {
  Context* c = current();
  if (!c) return nullptr;
  const char* text = nullptr;
  switch (name) {
    case GL_VENDOR:
      text = "Anteroom";
      break;
    case GL_RENDERER:
      text = c->rendererName.c_str();
      break;
    case GL_VERSION:
      text = "OpenGL ES-CM 1.1 Anteroom " ANTEROOM_VERSION;
      break;
    case GL_EXTENSIONS:
      if (c->extensions.empty()) c->extensions = join(c->device.caps());
      text = c->extensions.c_str();
      break;
    default:
      c->setError(GL_INVALID_ENUM, wrongEnum("name", name, "Use VENDOR, RENDERER, VERSION or EXTENSIONS"));
  }
  return reinterpret_cast<const GLubyte*>(text);
}
