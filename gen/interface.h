#pragma once

#include "gen/key.h"

namespace anteroom::gen {

// Whether the one shader writes all that the other reads, as those of one state do.
bool feeds(const VertexKey& vertex, const FragmentKey& fragment);

}  // namespace anteroom::gen
