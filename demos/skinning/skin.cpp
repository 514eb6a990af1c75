#include "skin.h"

#include <EGL/egl.h>

#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>

#include "room/context.h"
#include "room/transform.h"

namespace skinning {
namespace {

template <class Function>
Function entryPoint(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

const void* bufferOffset(std::size_t offset) {
  return reinterpret_cast<const void*>(offset);
}

// Neighbours differ.
glm::dvec3 boneColor(std::size_t bone) {
  const double hue = glm::two_pi<double>() * static_cast<double>(bone * 7 % kBones) / kBones;
  return 0.55 + 0.45 * glm::dvec3(std::cos(hue), std::cos(hue - 2.1), std::cos(hue + 2.1));
}

}  // namespace

Skin::Skin(std::string_view who, double scale) : mesh_(makeHand()), scale_(scale) {
  constexpr std::string_view kExtension = "GL_OES_matrix_palette";
  if (who == "palette") room::requireExtension(kExtension, "skinning (--skin cpu does without)");
  GLint units = 0, matrices = 0;
  if (who != "cpu" && room::hasExtension(kExtension)) {
    glGetIntegerv(GL_MAX_VERTEX_UNITS_OES, &units);
    glGetIntegerv(GL_MAX_PALETTE_MATRICES_OES, &matrices);
  }
  palette_ = units >= static_cast<GLint>(kInfluences) && matrices >= static_cast<GLint>(kBones);
  for (SkinVertex& v : mesh_.vertices) {
    v.position *= static_cast<float>(scale);
    glm::dvec3 color(0);
    for (std::size_t k = 0; k < kInfluences; ++k)
      color += static_cast<double>(v.weights[k]) * boneColor(v.bones[k]);
    const glm::dvec3 bytes = glm::round(255.0 * glm::clamp(color, 0.0, 1.0));
    boneColors_.push_back(
        {static_cast<GLubyte>(bytes.r), static_cast<GLubyte>(bytes.g), static_cast<GLubyte>(bytes.b), 255});
  }
  glGenBuffers(2, buffers_.data());
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh_.vertices.size() * sizeof(SkinVertex)),
               mesh_.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh_.indices.size() * sizeof(std::uint16_t)),
               mesh_.indices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  if (!palette_) {
    moved_.resize(mesh_.vertices.size());
    return;
  }
  currentPaletteMatrix_ = entryPoint<PFNGLCURRENTPALETTEMATRIXOESPROC>("glCurrentPaletteMatrixOES");
  matrixIndexPointer_ = entryPoint<PFNGLMATRIXINDEXPOINTEROESPROC>("glMatrixIndexPointerOES");
  weightPointer_ = entryPoint<PFNGLWEIGHTPOINTEROESPROC>("glWeightPointerOES");
}

Skin::~Skin() {
  glDeleteBuffers(2, buffers_.data());
}

void Skin::pose(const std::array<glm::dmat4, kBones>& bones, const glm::dmat4& place) {
  for (std::size_t i = 0; i < kBones; ++i) {
    // The vertices are scaled already: only moves are left to scale.
    glm::dmat4 bone = bones[i];
    bone[3] = glm::dvec4(glm::dvec3(bone[3]) * scale_, 1);
    bones_[i] = place * bone;
  }
  if (!palette_) blend();
}

void Skin::blend() {
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
    const SkinVertex& v = mesh_.vertices[i];
    glm::dvec3 position(0), normal(0);
    for (std::size_t k = 0; k < kInfluences; ++k) {
      const glm::dmat4& bone = bones_[v.bones[k]];
      const double weight = v.weights[k];
      position += weight * glm::dvec3(bone * glm::dvec4(v.position, 1));
      normal += weight * (glm::dmat3(bone) * glm::dvec3(v.normal));
    }
    moved_[i] = {position, normal};
  }
}

void Skin::begin(const glm::dmat4& view) const {
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glClientActiveTexture(GL_TEXTURE0);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, sizeof(SkinVertex), bufferOffset(offsetof(SkinVertex, uv)));
  if (palette_) {
    glVertexPointer(3, GL_FLOAT, sizeof(SkinVertex), bufferOffset(offsetof(SkinVertex, position)));
    glNormalPointer(GL_FLOAT, sizeof(SkinVertex), bufferOffset(offsetof(SkinVertex, normal)));
    glEnableClientState(GL_MATRIX_INDEX_ARRAY_OES);
    glEnableClientState(GL_WEIGHT_ARRAY_OES);
    matrixIndexPointer_(kInfluences, GL_UNSIGNED_BYTE, sizeof(SkinVertex),
                        bufferOffset(offsetof(SkinVertex, bones)));
    weightPointer_(kInfluences, GL_FLOAT, sizeof(SkinVertex), bufferOffset(offsetof(SkinVertex, weights)));
    glEnable(GL_MATRIX_PALETTE_OES);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  if (!palette_) {
    glVertexPointer(3, GL_FLOAT, sizeof(Moved), &moved_[0].position);
    glNormalPointer(GL_FLOAT, sizeof(Moved), &moved_[0].normal);
  }
  glEnable(GL_NORMALIZE);  // a sum of turned normals is a little short
  look(view);
}

void Skin::look(const glm::dmat4& view) const {
  if (palette_) {
    loadPalette(view);
  } else {
    glMatrixMode(GL_MODELVIEW);
    room::loadMatrix(view);
  }
}

void Skin::loadPalette(const glm::dmat4& view) const {
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  for (std::size_t i = 0; i < kBones; ++i) {
    currentPaletteMatrix_(static_cast<GLuint>(i));
    room::loadMatrix(view * bones_[i]);
  }
  glMatrixMode(GL_MODELVIEW);
}

void Skin::draw() const {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh_.indices.size()), GL_UNSIGNED_SHORT, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void Skin::showBones() const {
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, boneColors_.data());
}

void Skin::end() const {
  if (palette_) {
    glDisable(GL_MATRIX_PALETTE_OES);
    glDisableClientState(GL_MATRIX_INDEX_ARRAY_OES);
    glDisableClientState(GL_WEIGHT_ARRAY_OES);
  }
  glDisable(GL_NORMALIZE);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_COLOR_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

}  // namespace skinning
