#include "gen/inspect/words.h"

#include <fmt/format.h>

#include <ctime>
#include <sstream>

#include "gen/cache/generator_version.h"

namespace anteroom::inspect {

std::string name(int64_t id) {
  return fmt::format("{:016x}", static_cast<uint64_t>(id));
}

const char* kindName(gen::KeyKind kind) {
  constexpr const char* kNames[] = {"vertex", "fragment", "vertex-text", "fragment-text"};
  return kNames[static_cast<int>(kind)];
}

std::string ago(int64_t seconds) {
  const int64_t passed = std::time(nullptr) - seconds;
  if (passed < 0) return "in the future";
  if (passed < 120) return fmt::format("{} s", passed);
  if (passed < 2 * 3600) return fmt::format("{} min", passed / 60);
  if (passed < 2 * 86400) return fmt::format("{} h", passed / 3600);
  return fmt::format("{} d", passed / 86400);
}

std::string bytes(size_t count) {
  if (count < 10000) return fmt::format("{} B", count);
  if (count < 10000000) return fmt::format("{:.1f} KiB", static_cast<double>(count) / 1024);
  return fmt::format("{:.1f} MiB", static_cast<double>(count) / 1048576);
}

std::map<std::string, std::string> state(const gen::Row& row) {
  std::map<std::string, std::string> result;
  if (row.kind != gen::KeyKind::Vertex && row.kind != gen::KeyKind::Fragment) return result;
  std::istringstream words(row.description);
  std::string word;
  words >> word;  // the stage
  while (words >> word) {
    const size_t equals = word.find('=');
    result[word.substr(0, equals)] = equals == std::string::npos ? "on" : word.substr(equals + 1);
  }
  return result;
}

nlohmann::json toJson(int64_t id, const gen::Row& row, const std::string& why, bool whole) {
  // Text of a bad row may be no text at all.
  const auto clean = [](const std::string& text) {
    return nlohmann::json::parse(
        nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  };
  nlohmann::json json{{"key", name(id)},
                      {"kind", kindName(row.kind)},
                      {"description", clean(row.description)},
                      {"current", row.generator == gen::generatorVersion()},
                      {"generator", clean(row.generator)},
                      {"created", row.created},
                      {"used", row.used},
                      {"uses", row.uses},
                      {"compile_us", row.compileMicroseconds},
                      {"glsl_bytes", row.glsl.size()},
                      {"spirv_bytes", row.spirv.size() * sizeof(uint32_t)},
                      {"good", why.empty()}};
  if (!why.empty()) json["fault"] = why;
  if (whole) {
    json["glsl"] = clean(row.glsl);
    json["state"] = state(row);
  }
  return json;
}

}  // namespace anteroom::inspect
