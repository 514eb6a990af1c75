// Section 6.1.5: GetString, and the table of what the layer offers beyond the core.
#include <array>
#include <string>
#include <string_view>

#include "layer/gl/context.h"

using namespace anteroom::gl;

namespace {

// An extension is listed when all of it works.
constexpr std::array<std::string_view, 35> kExtensions{
    "GL_APPLE_texture_max_level",          // TEXTURE_MAX_LEVEL_APPLE
    "GL_EXT_blend_minmax",                 // MIN_EXT, MAX_EXT
    "GL_EXT_debug_marker",                 // event and group markers
    "GL_EXT_discard_framebuffer",          // DiscardFramebufferEXT
    "GL_EXT_map_buffer_range",             // MapBufferRangeEXT
    "GL_EXT_multi_draw_arrays",            // MultiDrawArraysEXT, MultiDrawElementsEXT
    "GL_EXT_texture_filter_anisotropic",   // TEXTURE_MAX_ANISOTROPY_EXT
    "GL_EXT_texture_lod_bias",             // TEXTURE_LOD_BIAS_EXT of a unit
    "GL_OES_blend_equation_separate",      // BlendEquationSeparateOES
    "GL_OES_blend_func_separate",          // BlendFuncSeparateOES
    "GL_OES_blend_subtract",               // BlendEquationOES
    "GL_OES_byte_coordinates",             // BYTE vertices and texture coordinates
    "GL_OES_compressed_paletted_texture",  // ten internal formats of CompressedTexImage2D
    "GL_OES_depth24",                      // renderbuffer format
    "GL_OES_draw_texture",                 // DrawTex...OES
    "GL_OES_element_index_uint",           // UNSIGNED_INT indices
    "GL_OES_fbo_render_mipmap",            // any level as an attachment
    "GL_OES_fixed_point",                  // ...x commands, FIXED arrays
    "GL_OES_framebuffer_object",           // framebuffer and renderbuffer objects, GenerateMipmapOES
    "GL_OES_mapbuffer",                    // MapBufferOES
    "GL_OES_matrix_get",                   // ..._MATRIX_FLOAT_AS_INT_BITS_OES
    "GL_OES_packed_depth_stencil",         // renderbuffer format DEPTH24_STENCIL8_OES
    "GL_OES_point_size_array",             // PointSizePointerOES
    "GL_OES_point_sprite",                 // POINT_SPRITE_OES, COORD_REPLACE_OES
    "GL_OES_query_matrix",                 // QueryMatrixxOES
    "GL_OES_read_format",                  // IMPLEMENTATION_COLOR_READ_FORMAT_OES and _TYPE_OES
    "GL_OES_rgb8_rgba8",                   // renderbuffer formats
    "GL_OES_single_precision",             // ...f commands
    "GL_OES_stencil8",                     // renderbuffer format
    "GL_OES_stencil_wrap",                 // INCR_WRAP_OES, DECR_WRAP_OES
    "GL_OES_texture_cube_map",             // TEXTURE_CUBE_MAP_OES, TEXTURE_GEN_STR_OES
    "GL_OES_texture_env_crossbar",         // any TEXTUREn as a source
    "GL_OES_texture_mirrored_repeat",      // MIRRORED_REPEAT_OES
    "GL_OES_texture_npot",                 // sizes that are no power of two, with mip levels and REPEAT
    "GL_OES_vertex_array_object",          // vertex array objects
};

// What some devices lack.
bool offered(const anteroom::render::Caps& caps, std::string_view name) {
  return name != "GL_EXT_texture_filter_anisotropic" || caps.maxAnisotropy >= 2;
}

std::string join(const anteroom::render::Caps& caps) {
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
      text = "OpenGL ES-CM 1.1";
      break;
    case GL_EXTENSIONS:
      if (c->extensions.empty()) c->extensions = join(c->device.caps());
      text = c->extensions.c_str();
      break;
    default:
      c->setError(GL_INVALID_ENUM);
  }
  return reinterpret_cast<const GLubyte*>(text);
}
