// Everything that Enable and Disable switch (tables 6.7 to 6.17).
#pragma once

#include "layer/gl/context.h"

namespace anteroom::gl {

// A switch of the context, and the groups that it belongs to.
struct Capability {
  bool* enabled = nullptr;  // null: there is no such capability
  gen::Groups groups = 0;
};
Capability capabilityOf(Context& c, GLenum name);

// IsEnabled: capabilities and client arrays. False: there is neither.
bool isEnabled(Context& c, GLenum name, bool& enabled);

}  // namespace anteroom::gl
