// Where the cache is.
#pragma once

#include <filesystem>
#include <string>

namespace anteroom::cache {

struct CacheLocation {
  std::filesystem::path file;  // empty: there is no cache
  std::string reason;          // why there is none; empty when that was asked for
};

// $ANTEROOM_CACHE_DIR/anteroom.db, else $XDG_CACHE_HOME/anteroom/anteroom.db, else
// ~/.cache/anteroom/anteroom.db. ANTEROOM_CACHE=off: none. Programs that run with another's rights ignore the
// environment, and have none.
CacheLocation cacheLocation();

// $ANTEROOM_CACHE_LIMIT in bytes (suffixes K, M and G), else 64 MiB.
uint64_t cacheLimit();

}  // namespace anteroom::cache
