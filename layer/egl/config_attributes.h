// What a config says of itself (table 3.1), and how each of it is asked for (table 3.4).
#pragma once

#include <EGL/egl.h>

#include <span>

#include "layer/egl/config.h"

namespace anteroom::egl {

// "Selection Criteria". Special: looked at apart from the others, or ignored.
enum class Match : uint8_t { AtLeast, Exact, Mask, Special };

// "Sort Priority": configs with the smaller value of the lower rule come first.
enum SortRule : uint8_t {
  kUnsorted = 0,
  kRequestedColorBits = 3,  // the larger sum of the components that were asked for
  kLastSortRule = 11,
};

struct ConfigAttribute {
  EGLint name;
  EGLint initial;  // asked for where a list does not say
  Match match;
  uint8_t sortRule;
  bool (*legal)(EGLint value);     // whether a list may ask for it
  EGLint (*value)(const Config&);  // null: it is there to be asked for, configs have none
};

std::span<const ConfigAttribute> configAttributes();

// Null: no such attribute.
const ConfigAttribute* configAttribute(EGLint name);

}  // namespace anteroom::egl
