// The renderer's own shaders, which no key makes: the files of shaders/own, embedded by CMake.
#pragma once

#include <span>

#include "gen/gen.h"

namespace anteroom::vulkan {

struct OwnShader {
  gen::Stage stage;
  const char* text;  // GLSL
};
// quad_vertex.glsl and so on.
extern const OwnShader kQuadVertex, kFlatFragment, kCopyFragment, kHudFragment;
// All that there are.
std::span<const OwnShader* const> ownShaders();

// Whether statistics tell of what is made, and a later run makes it ahead.
enum class Counted : bool { No, Yes };

}  // namespace anteroom::vulkan
