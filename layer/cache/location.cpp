#include "layer/cache/location.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace anteroom::cache {
namespace {

constexpr uint64_t kDefaultLimit = 64 << 20;

std::string_view variable(const char* name) {
  const char* value = secure_getenv(name);
  return value ? value : "";
}

}  // namespace

CacheLocation cacheLocation() {
  const char* const file = "anteroom.db";
  if (variable("ANTEROOM_CACHE") == "off") return {};
  if (const auto folder = variable("ANTEROOM_CACHE_DIR"); !folder.empty())
    return {std::filesystem::path(folder) / file, {}};
  // Relative paths are to be ignored (XDG base directory specification).
  if (const auto folder = variable("XDG_CACHE_HOME"); folder.starts_with('/'))
    return {std::filesystem::path(folder) / "anteroom" / file, {}};
  if (const auto home = variable("HOME"); home.starts_with('/'))
    return {std::filesystem::path(home) / ".cache" / "anteroom" / file, {}};
  return {{}, "there is no home directory: set ANTEROOM_CACHE_DIR, or ANTEROOM_CACHE=off"};
}

uint64_t cacheLimit() {
  const std::string_view text = variable("ANTEROOM_CACHE_LIMIT");
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view suffix(end, static_cast<size_t>(text.data() + text.size() - end));
  const int shift = suffix.empty() ? 0 : suffix == "K" ? 10 : suffix == "M" ? 20 : suffix == "G" ? 30 : -1;
  if (text.empty() || error != std::errc() || shift < 0 || value > (UINT64_MAX >> shift))
    return kDefaultLimit;
  return value << shift;
}

}  // namespace anteroom::cache
