// Vertex arrays as draws and queries see them (section 2.8).
#pragma once

#include "layer/gl/context/context.h"

namespace anteroom::gl {

// Bytes of one component of an array.
uint32_t bytesOf(GLenum type);

// The attribute that GL_VERTEX_ARRAY and so on mean (GL_TEXTURE_COORD_ARRAY: of the client's active unit).
// False: no such array.
bool attributeOf(const Context& c, GLenum array, gen::Attribute& attribute);

// Brings the renderer's view of one array, or of all, up to date. Under the ShareLock, for stores may be
// replaced.
void syncArray(Context& c, size_t attribute);
void syncArrays(Context& c);

}  // namespace anteroom::gl
