// Highlights a pixel, section 2.3 of the paper: a cube map that holds nothing but a highlight, looked up by
// reflection mapping.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include "light_vectors.h"
#include "room/texture.h"

namespace lighting {

class Specular {
 public:
  // Throws room::MissingExtension without cube maps.
  Specular();
  // color += highlight * gloss * light color * destination alpha, on the parts that shine.
  void draw(const LightVectors& lit, const Spotlight& light, const glm::dmat4& view) const;

 private:
  PFNGLTEXGENIOESPROC texGeni_ = nullptr;
  room::Texture highlight_;
};

}  // namespace lighting
