// fork() without exec. No Vulkan device survives it: in the child no display is initialized, nothing is
// current, and commands of GL do nothing. The child may initialize anew.
#pragma once

namespace anteroom::egl {

// From now on. Under the lock, after a renderer has registered what it does at a fork.
void watchForks();

}  // namespace anteroom::egl
