#include "layer/tools/cache/words.h"

#include <fmt/format.h>

#include <ctime>
#include <sstream>

namespace anteroom::inspect {
namespace {

// What a program sets, by how the names of what comes of it begin; the first that fits. "#" is the unit's
// number.
struct Topic {
  std::string_view begins, topic;
};
constexpr Topic kVertexTopics[] = {
    {"coord", "texture unit #"},  {"out", "texture unit #"}, {"texgen", "texture unit #"},
    {"matrix", "texture unit #"}, {"q1-", "texture unit #"}, {"fog", "fog"},
    {"clip", "clip planes"},      {"point", "points"},       {"size", "points"},
    {"positional", "lighting"},   {"position", "arrays"},    {"color-material", "lighting"},
    {"color", "arrays"},          {"own-values", "batching"}};
constexpr Topic kFragmentTopics[] = {{"unit", "texture unit #"},
                                     {"read", "texture unit #"},
                                     {"rgb", "texture unit #"},
                                     {"alpha-test", "alpha test"},
                                     {"alpha", "texture unit #"},
                                     {"point", "points"},
                                     {"fog", "fog"},
                                     {"flat", "shade model"},
                                     {"two-sided", "lighting"},
                                     {"discard-planes", "clip planes"}};
constexpr Topic kStateTopics[] = {
    {"primitive", "primitive"}, {"front", "culling"},        {"cull", "culling"},
    {"line-mode", "primitive"}, {"depth-", "depth test"},    {"stencil-", "stencil test"},
    {"array", "arrays"},        {"color", "framebuffer"},    {"depth", "framebuffer"},
    {"sample", "framebuffer"},  {"alpha-to", "framebuffer"}, {"dynamic", "device"}};

std::string topicOf(std::string_view field, std::span<const Topic> topics, std::string_view otherwise) {
  for (const Topic& topic : topics) {
    if (!field.starts_with(topic.begins)) continue;
    std::string text(topic.topic);
    if (text.ends_with('#')) text.back() = field.back();
    return text;
  }
  return std::string(otherwise);
}

bool isKey(const std::string& words) {
  return words.find('\n') == std::string::npos;
}

// The words of one description, without the stage.
template <class Visit>
void visitWords(const std::string& description, bool withStage, Visit visit) {
  std::istringstream words(description);
  std::string word;
  if (withStage) words >> word;
  while (words >> word) {
    const size_t equals = word.find('=');
    visit(word.substr(0, equals), equals == std::string::npos ? "on" : word.substr(equals + 1));
  }
}

void addTopics(const std::string& description, bool withStage, std::span<const Topic> topics,
               std::string_view otherwise, State& out) {
  visitWords(description, withStage, [&](const std::string& field, const std::string& value) {
    std::string& text = out[topicOf(field, topics, otherwise)];
    text += (text.empty() ? "" : " ") + field + (value == "on" ? "" : "=" + value);
  });
}

}  // namespace

std::string name(int64_t id) {
  return fmt::format("{:016x}", static_cast<uint64_t>(id));
}

const char* kindName(cache::KeyKind kind) {
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

std::string milliseconds(int64_t microseconds) {
  return fmt::format("{:.2f} ms", static_cast<double>(microseconds) / 1000);
}

State state(const cache::ShaderRow& row) {
  State result;
  if (row.kind != cache::KeyKind::Vertex && row.kind != cache::KeyKind::Fragment) return result;
  visitWords(row.description, true,
             [&](const std::string& field, const std::string& value) { result[field] = value; });
  return result;
}

State state(const cache::PipelineRow& row) {
  State result;
  if (isKey(row.vertex)) {
    addTopics(row.vertex, true, kVertexTopics, "lighting", result);
    addTopics(row.fragment, true, kFragmentTopics, "fragments", result);
  } else {
    result["shaders"] = "the renderer's own";
  }
  addTopics(row.state, false, kStateTopics, "blending", result);
  return result;
}

std::string valueOf(const State& state, const std::string& field) {
  const auto found = state.find(field);
  return found == state.end() ? "-" : found->second;
}

std::string clean(const std::string& text) {
  return nlohmann::json::parse(
      nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

nlohmann::json toJson(const Shader& shader, bool whole) {
  const cache::ShaderRow& row = shader.row;
  nlohmann::json json{{"key", name(shader.id)},
                      {"kind", kindName(row.kind)},
                      {"description", clean(row.description)},
                      {"current", row.current()},
                      {"generator", clean(row.generator)},
                      {"created", row.created},
                      {"used", row.used},
                      {"uses", row.uses},
                      {"compile_us", row.compileMicroseconds},
                      {"glsl_bytes", row.glsl.size()},
                      {"spirv_bytes", row.spirv.size() * sizeof(uint32_t)},
                      {"good", shader.why.empty()}};
  if (!shader.why.empty()) json["fault"] = shader.why;
  if (whole) {
    json["glsl"] = clean(row.glsl);
    for (const auto& [field, value] : state(row)) json["state"][clean(field)] = clean(value);
  }
  return json;
}

nlohmann::json toJson(const Pipeline& pipeline, bool whole) {
  const cache::PipelineRow& row = pipeline.row;
  nlohmann::json json{{"key", name(pipeline.id)},
                      {"kind", "pipeline"},
                      {"state", clean(row.state)},
                      {"created", row.created},
                      {"used", row.used},
                      {"uses", row.uses},
                      {"create_us", row.createMicroseconds},
                      {"good", pipeline.why.empty()}};
  if (!pipeline.why.empty()) json["fault"] = pipeline.why;
  if (whole) {
    json["vertex"] = clean(row.vertex);
    json["fragment"] = clean(row.fragment);
    for (const auto& [field, value] : state(row)) json["topics"][clean(field)] = clean(value);
  }
  return json;
}

}  // namespace anteroom::inspect
