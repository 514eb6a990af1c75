// What commands that write have in common.
#pragma once

#include <optional>
#include <string>

#include "layer/tools/cache/read.h"

namespace anteroom::inspect {

// Nothing: the key does not compile.
std::optional<gen::ShaderRow> compiled(gen::KeyKind kind, gen::KeyBytes key);

// A transaction, and its end; both say on stderr what is wrong.
Status begin(const Settings& settings, gen::Store::Mode mode, gen::Store& store);
Status finish(gen::Store& store, const Settings& settings, bool good);

// A file of text.
Status write(const std::string& file, const std::string& text);

}  // namespace anteroom::inspect
