// Rows in words.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "layer/tools/cache/read.h"

namespace anteroom::inspect {

std::string name(int64_t id);  // 16 hex digits
const char* kindName(cache::KeyKind kind);
std::string ago(int64_t seconds);  // since 1970
std::string bytes(size_t count);
std::string milliseconds(int64_t microseconds);

// The state of a key: "fog" -> "linear". What a key leaves out has its plainest value, and is left out here.
using State = std::map<std::string, std::string>;
State state(const cache::ShaderRow& row);
// Of both shaders and the rest, grouped by what a program sets: "texture unit 0", "fog", "blending".
State state(const cache::PipelineRow& row);
// "-" for what is left out.
std::string valueOf(const State& state, const std::string& field);

// Text that may be none, as valid UTF-8.
std::string clean(const std::string& text);
nlohmann::json toJson(const Shader& shader, bool whole);
nlohmann::json toJson(const Pipeline& pipeline, bool whole);

}  // namespace anteroom::inspect
