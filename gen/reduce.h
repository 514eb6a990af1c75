// Removes from a key what its shader does not read. Reducing twice is reducing once, so a key is canonical
// when reducing leaves it as it is.
#pragma once

#include "gen/key.h"

namespace anteroom::gen {

void reduce(FragmentKey& key);
void reduce(VertexKey& key);

// Whether the fragment stage reads the color that the vertex stage makes.
bool readsPrimaryColor(const FragmentKey& key);
// Whether the vertex stage needs the eye coordinates, or a normal, of a vertex.
bool needsEye(const VertexKey& key);
bool needsNormal(const VertexKey& key);

}  // namespace anteroom::gen
