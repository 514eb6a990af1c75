// OES_draw_texture: rectangles of texels in window coordinates.
#include <array>

#include "layer/gl/context/params.h"
#include "layer/gl/textures/texture.h"
#include "layer/gl/vertices/draw.h"
#include "layer/gl/vertices/vertex_arrays.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;
namespace render = anteroom::render;

namespace {

struct Corner {
  glm::vec2 position;  // normalised device coordinates
  std::array<glm::vec2, gen::kMaxTextureUnits> texCoord;
};

struct Box {
  double x, y, z, width, height;  // pixels; depth in [0, 1]
};

// Groups in which the state of a rectangle's draw differs from the program's.
constexpr gen::Groups kDiffers = gen::kGroupModelview | gen::kGroupProjection | gen::kGroupTextureMatrix |
                                 gen::kGroupArrays | gen::kGroupLighting | gen::kGroupTextures |
                                 gen::kGroupClipPlanes | gen::kGroupRaster | gen::kGroupViewport |
                                 gen::kGroupPalette | gen::kGroupPrimitive;

void setArray(render::State& state, int index, const void* pointer) {
  gen::AttributeState& attribute = state.fixed.attributes[static_cast<size_t>(index)];
  attribute.array = true;
  attribute.size = 2;
  attribute.type = GL_FLOAT;
  state.arrays[static_cast<size_t>(index)] = {nullptr, pointer, sizeof(Corner)};
}

// The rectangle's corners, in the order of a triangle strip.
std::array<Corner, 4> cornersOf(const Context& c, const Box& box) {
  std::array<Corner, 4> corners{};
  const render::Framebuffer& framebuffer = c.state.framebuffer;
  for (size_t i = 0; i < corners.size(); ++i) {
    const double right = i % 2 == 0 ? 0 : 1, top = i < 2 ? 0 : 1;
    corners[i].position = {(box.x + right * box.width) * 2 / framebuffer.width - 1,
                           (box.y + top * box.height) * 2 / framebuffer.height - 1};
    for (size_t unit = 0; unit < gen::kMaxTextureUnits; ++unit) {
      const UnitBindings& bindings = c.units[unit];
      if (bindings.sampled == kSlotCount) continue;
      const Texture& texture = *bindings.bound[bindings.sampled];
      const auto& crop = texture.cropRect;
      const TextureLevel& base = texture.at(0, 0);
      corners[i].texCoord[unit] = {(crop[0] + right * crop[2]) / base.width,
                                   (crop[1] + top * crop[3]) / base.height};
    }
  }
  return corners;
}

// The rectangle is drawn by the state that the program set, but for what section 5.7 leaves out.
void drawBox(Context& c, const Box& box, const char* command) {
  prepareDraw(c);
  const std::array<Corner, 4> corners = cornersOf(c, box);
  render::State state = c.state;
  for (gen::AttributeState& attribute : state.fixed.attributes) attribute.array = false;
  setArray(state, gen::kPosition, &corners[0].position);
  for (int unit = 0; unit < gen::kMaxTextureUnits; ++unit) {
    gen::TextureUnit& to = state.fixed.units[static_cast<size_t>(unit)];
    to.matrix = glm::dmat4(1.0);
    to.texGen = false;
    if (to.target != gen::TextureTarget::None) {
      setArray(state, gen::texCoord(unit), &corners[0].texCoord[static_cast<size_t>(unit)]);
    }
  }
  // The fragment's distance for fog is 0: the eye plane z = 0, moved by the projection.
  state.fixed.modelview = state.fixed.projection = glm::dmat4(1.0);
  const double z = box.z > 0 ? (box.z < 1 ? box.z : 1) : 0;
  state.fixed.projection[3][2] = 2 * z - 1;
  state.fixed.palette = nullptr;
  state.fixed.lighting.enabled = false;
  for (gen::ClipPlane& plane : state.fixed.clipPlanes) plane.enabled = false;
  state.fixed.primitive = gen::PrimitiveClass::Triangles;
  state.raster.cullFace = state.raster.polygonOffsetFill = false;
  state.fixed.viewport = {0, 0, state.framebuffer.width, state.framebuffer.height};

  render::DrawCall call;
  call.mode = GL_TRIANGLE_STRIP;
  call.count = 4;
  submitDraw(c, state, kDiffers, call, command);
}

void drawTexture(double x, double y, double z, double width, double height,
                 const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (!(width > 0) || !(height > 0))
    return c->setError(
        GL_INVALID_VALUE,
        wrongNumber(width > 0 ? "height" : "width", width > 0 ? height : width, "Give a size above 0"),
        command);
  ShareLock lock(*c->group);
  if (!c->framebufferComplete()) return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES, {}, command);
  drawBox(*c, {x, y, z, width, height}, command);
}

}  // namespace

GL_API void GL_APIENTRY glDrawTexfOES(GLfloat x, GLfloat y, GLfloat z, GLfloat width, GLfloat height) {
  drawTexture(x, y, z, width, height);
}
GL_API void GL_APIENTRY glDrawTexsOES(GLshort x, GLshort y, GLshort z, GLshort width, GLshort height) {
  drawTexture(x, y, z, width, height);
}
GL_API void GL_APIENTRY glDrawTexiOES(GLint x, GLint y, GLint z, GLint width, GLint height) {
  drawTexture(x, y, z, width, height);
}
GL_API void GL_APIENTRY glDrawTexxOES(GLfixed x, GLfixed y, GLfixed z, GLfixed width, GLfixed height) {
  drawTexture(fixedToDouble(x), fixedToDouble(y), fixedToDouble(z), fixedToDouble(width),
              fixedToDouble(height));
}
GL_API void GL_APIENTRY glDrawTexfvOES(const GLfloat* coords) {
  if (coords) glDrawTexfOES(coords[0], coords[1], coords[2], coords[3], coords[4]);
}
GL_API void GL_APIENTRY glDrawTexsvOES(const GLshort* coords) {
  if (coords) glDrawTexsOES(coords[0], coords[1], coords[2], coords[3], coords[4]);
}
GL_API void GL_APIENTRY glDrawTexivOES(const GLint* coords) {
  if (coords) glDrawTexiOES(coords[0], coords[1], coords[2], coords[3], coords[4]);
}
GL_API void GL_APIENTRY glDrawTexxvOES(const GLfixed* coords) {
  if (coords) glDrawTexxOES(coords[0], coords[1], coords[2], coords[3], coords[4]);
}
