// What every draw does (section 2.8). All under the ShareLock.
#pragma once

#include "layer/gl/context/context.h"

namespace anteroom::gl {

// Brings the renderer's view of arrays, textures and attachments up to date.
void prepareDraw(Context& c);

// Hands a prepared draw to the renderer. `state` differs from the context's in no group but those of
// `differs`.
void submitDraw(Context& c, const render::State& state, gen::Groups differs, const render::DrawCall& call,
                const char* command = __builtin_FUNCTION());

}  // namespace anteroom::gl
