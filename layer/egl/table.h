#pragma once

#include "layer/egl/commands.h"

namespace anteroom::egl {

extern const CommandTable kCommandTable;

}  // namespace anteroom::egl
