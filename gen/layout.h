// The constant blocks: which members a key's shader has, in GLSL and as bytes. layout.cpp is the only place
// that knows, but for the palette's (gen/palette.h); blocks() and pack* of gen/gen.h are implemented by it.
#pragma once

#include <string>

#include "gen/key.h"

namespace anteroom::gen {

// GLSL declarations, each empty when the block is. Push: inputs, where vertices bring them.
std::string declarePush(const VertexKey& key);
std::string declareVertexConstants(const VertexKey& key);
std::string declareFragmentConstants(const FragmentKey& key);

}  // namespace anteroom::gen
