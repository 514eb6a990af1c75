#include "reflection.h"

#include <EGL/egl.h>

#include <stdexcept>

#include "context.h"
#include "passes.h"

namespace room {

ReflectionMapping::ReflectionMapping(std::string_view demo) {
  requireExtension("GL_OES_texture_cube_map", demo);
  texGeni_ = reinterpret_cast<PFNGLTEXGENIOESPROC>(eglGetProcAddress("glTexGeniOES"));
  if (texGeni_ == nullptr) throw std::runtime_error("eglGetProcAddress does not know glTexGeniOES");
}

void ReflectionMapping::enable(int unit, const CubeTarget& surroundings, const glm::dmat4& view) const {
  loadTextureMatrix(unit, glm::dmat4(glm::transpose(glm::dmat3(view))));
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  surroundings.bindTexture();
  glEnable(GL_TEXTURE_GEN_STR_OES);
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
}

void ReflectionMapping::disable(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glDisable(GL_TEXTURE_CUBE_MAP_OES);
  glDisable(GL_TEXTURE_GEN_STR_OES);
}

}  // namespace room
