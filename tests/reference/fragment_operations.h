// Sections 3.8 to 4.1: a fragment through textures, fog, tests and blending into the framebuffer.
#pragma once

#include "tests/reference/image_store.h"
#include "tests/reference/rasterisation.h"

namespace anteroom::reference {

class FragmentStage {
 public:
  explicit FragmentStage(const render::State& state);
  // Colors written here are not yet rounded: quantiseColor does that once a draw.
  void process(const Fragment& fragment) const;

 private:
  glm::dvec4 shade(const Fragment& fragment) const;
  bool alphaTest(double alpha) const;
  uint32_t coverageMask(const Fragment& fragment, double alpha) const;
  bool depthAndStencil(const Fragment& fragment, int sample) const;
  glm::dvec4 blend(const glm::dvec4& source, const glm::dvec4& destination) const;

  const render::State& state_;
  StoredImage* color_ = nullptr;
  StoredImage* depth_ = nullptr;
  StoredImage* stencil_ = nullptr;
  int stencilMax_ = 255;
};

// Rounds rows [fromRow, toRow) of the color attachment to its format.
void quantiseColor(const render::Framebuffer& framebuffer, int fromRow, int toRow);

// GL's window row as a row of the attachments.
int memoryRow(const render::Framebuffer& framebuffer, int y);

}  // namespace anteroom::reference
