// The hand as it is drawn: its vertices in buffers, moved by the matrix palette (OES_matrix_palette) or by
// the program.
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "set/hand.h"

namespace skinning {

class Skin {
 public:
  // `who`: room::Settings::skin. `scale`: metres of a millimetre of the hand. Throws room::MissingExtension
  // where the palette is asked for and there is none.
  Skin(std::string_view who, double scale);
  ~Skin();
  Skin(const Skin&) = delete;
  Skin& operator=(const Skin&) = delete;

  // Where the bones are from now on; `place` takes the wrist to where it is in the room, without any scale.
  void pose(const std::array<glm::dmat4, kBones>& bones, const glm::dmat4& place);
  // Points the arrays at the hand, enabled: positions, normals and the texture coordinates of unit 0.
  // Positions and normals come to eye coordinates by `view`, whose last row may be any.
  void begin(const glm::dmat4& view) const;
  // Once more with another view.
  void look(const glm::dmat4& view) const;
  void draw() const;
  // Disables all that begin() enabled.
  void end() const;
  // A color a vertex, mixed from its bones': the color array is enabled until end().
  void showBones() const;

 private:
  struct Moved {
    glm::vec3 position, normal;
  };
  void blend();
  void loadPalette(const glm::dmat4& view) const;

  HandMesh mesh_;
  double scale_;
  bool palette_;
  std::array<glm::dmat4, kBones> bones_;
  std::vector<Moved> moved_;  // by the program
  std::vector<std::array<GLubyte, 4>> boneColors_;
  std::array<GLuint, 2> buffers_{};
  PFNGLCURRENTPALETTEMATRIXOESPROC currentPaletteMatrix_ = nullptr;
  PFNGLMATRIXINDEXPOINTEROESPROC matrixIndexPointer_ = nullptr;
  PFNGLWEIGHTPOINTEROESPROC weightPointer_ = nullptr;
};

}  // namespace skinning
