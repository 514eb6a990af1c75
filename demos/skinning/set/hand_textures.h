// What the hand is painted with.
#pragma once

#include "room/image.h"

namespace skinning {

// Glazed porcelain with the lines and signs of palmistry. RGB the color, A the gloss.
room::Image handBase();

}  // namespace skinning
