// What commands that write have in common.
#pragma once

#include <optional>
#include <string>

#include "layer/tools/cache/read.h"

namespace anteroom::inspect {

// Nothing: the key does not compile.
std::optional<cache::ShaderRow> compiled(cache::KeyKind kind, cache::KeyBytes key);

// A transaction, and its end; both say on stderr what is wrong.
Status begin(const Settings& settings, cache::Store::Mode mode, cache::Store& store);
Status finish(cache::Store& store, const Settings& settings, bool good);

// A file of text.
Status write(const std::string& file, const std::string& text);

}  // namespace anteroom::inspect
