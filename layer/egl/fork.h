// fork() without exec. No Vulkan device survives it: in the child no display is initialized, nothing is
// current, and commands of GL do nothing. The child may initialize anew.
#pragma once

namespace anteroom::egl {

// Registers, once, what does this at a fork. Under the lock, after a renderer has registered its own.
void registerForkHandlers();

}  // namespace anteroom::egl
