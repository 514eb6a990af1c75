// How hand and crystal ball are lit, section 7.2 of the paper: diffuse light a vertex by GL's lights, and highlights
// a pixel from a cube map, times the gloss in the base map's alpha, in a single pass.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <string_view>

#include "room/texture.h"
#include "set/parlour.h"

namespace skinning {

class Glaze {
 public:
  // middle: where the parlour is mirrored from. Needs cube maps and GL_OES_texture_env_crossbar.
  Glaze(const Parlour& parlour, const glm::dvec3& middle);

  // Unit 0 RGB = Base.RGB * Diffuse.RGB, alpha = Specular.A * Base.A; unit 1 RGB = Previous.RGB + Previous.A.
  // stage: "diffuse" and "specular" leave the other part out.
  void begin(std::string_view stage, const room::Texture& base, const glm::dmat4& view) const;
  void end() const;

 private:
  PFNGLTEXGENIOESPROC texGeni_ = nullptr;
  room::Texture highlights_;
};

// GL's lights and materials: lamp, candles and moon; loads the camera's matrix. flicker: what the candles leave
// of their light.
void placeLights(const Parlour& parlour, const glm::dmat4& view, double flicker);

}  // namespace skinning
