// A program that holds this has another generator version.
#include "layer/cache/generator_version.h"

namespace anteroom::cache {

std::string_view generatorVersion() {
  return "0123456789abcdef";
}

}  // namespace anteroom::cache
