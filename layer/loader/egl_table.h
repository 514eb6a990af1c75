// The one symbol between the two libraries.
#pragma once

#include "layer/egl/commands.h"

extern "C" const anteroom::egl::CommandTable* glAnteroomEglTable();
