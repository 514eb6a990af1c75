// Rows in words.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "gen/cache/store.h"

namespace anteroom::inspect {

std::string name(int64_t id);  // 16 hex digits
const char* kindName(gen::KeyKind kind);
std::string ago(int64_t seconds);  // since 1970
std::string bytes(size_t count);

// The state of a key: "fog" -> "linear". What a key leaves out has its plainest value, and is left out here.
std::map<std::string, std::string> state(const gen::Row& row);

nlohmann::json toJson(int64_t id, const gen::Row& row, const std::string& why, bool whole);

}  // namespace anteroom::inspect
