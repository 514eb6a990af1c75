// Tables of words by number.
#pragma once

#include <array>
#include <string_view>

namespace anteroom::gen {

// A word for each value from 0 to kLast; any other number of words does not compile.
template <auto kLast, class... Text>
constexpr std::array<std::string_view, sizeof...(Text)> wordsTo(Text... words) {
  static_assert(sizeof...(Text) == static_cast<size_t>(kLast) + 1, "each value has one word");
  return {words...};
}

}  // namespace anteroom::gen
