#pragma once

#include "layer/tools/info/facts.h"

namespace info {

// To standard output. `brief`: without extensions, configs and limits.
void print(const Facts& facts, bool brief);
void printJson(const Facts& facts);

}  // namespace info
