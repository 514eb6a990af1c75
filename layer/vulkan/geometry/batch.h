// Which draws become one. Consecutive small draws that differ only in their vertices, and in values that
// their vertices carry, do: on every driver the cost of a small draw is the draw, not its vertices.
#pragma once

#include <cstdint>

#include "gen/gen.h"
#include "layer/render/state.h"
#include "layer/vulkan/pipelines/vertex_layout.h"

namespace anteroom::vulkan {

// The most vertices of a draw whose vertices carry all values, and which may be in a batch.
inline constexpr uint32_t kMostCarrying = 36;

// A draw without indices whose mode draws separate primitives.
bool isPlain(const render::DrawCall& call);

// Decides, and counts what it decides by; it knows nothing of where vertices lie.
class Batch {
 public:
  // carriesValues: the device takes as many vertex inputs as carried values need.
  explicit Batch(bool carriesValues) : carriesValues_(carriesValues) {}

  // What the vertices of the draws of this time carry.
  Carried carried() const { return carried_; }
  // Whether the draw can be in a batch.
  bool isSmall(const render::DrawCall& call) const { return isSmall(call, carried_); }

  // Whether the draw may join those before it, of which `held` vertices wait to be drawn. `changed`: the
  // state's groups that changed since; `read`: what the shaders read.
  bool accepts(const render::DrawCall& call, gen::Groups changed, const gen::Blocks& read,
               uint32_t held) const;
  void opened(GLenum mode);
  void joined() { alone_ = 0; }

  // To be called for each draw that joins none. A program that changes matrices or the current color between
  // small draws has them copied to each vertex, so that these draws can be one. That takes a shader of its
  // own: it must have happened often, in a row. Groups that the draw must look at again therefore.
  gen::Groups chooseCarried(const render::State& state, const render::DrawCall& call, gen::Groups changed,
                            const gen::Blocks& read);

 private:
  bool isSmall(const render::DrawCall& call, Carried carried) const;
  gen::Groups mayChange(const gen::Blocks& read) const;
  gen::Groups setCarried(Carried carried);

  const bool carriesValues_;
  Carried carried_ = Carried::Nothing;
  GLenum mode_ = GL_TRIANGLES;  // of the open batch
  uint32_t valueChanges_ = 0;   // draws in a row that only a change of values kept apart
  uint32_t valueChangesNeeded_ = 32;
  uint32_t alone_ = 0;  // draws in a row that carried values, and that none joined
};

}  // namespace anteroom::vulkan
