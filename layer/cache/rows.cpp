#include "layer/cache/rows.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>

#include "layer/cache/generator_version.h"

namespace anteroom::cache {
namespace {

constexpr size_t kLongestText = 1 << 20;
constexpr std::string_view kTextBegins = "#version";

template <class Key>
Key as(KeyBytes bytes) {
  Key key;
  std::memcpy(&key, bytes.data(), sizeof key);
  return key;
}

template <class Key>
bool isValid(KeyBytes bytes) {
  return bytes.size() == sizeof(Key) && valid(as<Key>(bytes));
}

std::string_view textOf(KeyBytes key) {
  return {reinterpret_cast<const char*>(key.data()), key.size()};
}

template <class Key>
bool parsed(const std::string& words, std::vector<std::byte>& bytes) {
  Key key;
  if (!parse(words, key)) return false;
  const auto view = bytesOf(key);
  bytes.assign(view.begin(), view.end());
  return true;
}

}  // namespace

int64_t shaderId(KeyKind kind, KeyBytes key) {
  return static_cast<int64_t>(XXH3_64bits_withSeed(key.data(), key.size(), static_cast<uint64_t>(kind)));
}

int64_t shaderNumber(int64_t id, std::string_view generator) {
  return id ^ static_cast<int64_t>(XXH3_64bits(generator.data(), generator.size()));
}

bool validKey(KeyKind kind, KeyBytes key) {
  switch (kind) {
    case KeyKind::Vertex:
      return isValid<gen::VertexKey>(key);
    case KeyKind::Fragment:
      return isValid<gen::FragmentKey>(key);
    case KeyKind::VertexText:
    case KeyKind::FragmentText:
      return key.size() <= kLongestText && textOf(key).starts_with(kTextBegins);
  }
  return false;
}

std::string emit(KeyKind kind, KeyBytes key) {
  if (kind == KeyKind::Vertex) return emitVertex(as<gen::VertexKey>(key));
  if (kind == KeyKind::Fragment) return emitFragment(as<gen::FragmentKey>(key));
  return std::string(textOf(key));
}

std::string wordsOf(KeyKind kind, KeyBytes key) {
  if (kind == KeyKind::Vertex) return describe(as<gen::VertexKey>(key));
  if (kind == KeyKind::Fragment) return describe(as<gen::FragmentKey>(key));
  return std::string(textOf(key));
}

bool keyOf(gen::Stage stage, const std::string& words, KeyKind& kind, std::vector<std::byte>& key) {
  const bool vertex = stage == gen::Stage::Vertex;
  if (words.starts_with(kTextBegins)) {
    kind = vertex ? KeyKind::VertexText : KeyKind::FragmentText;
    const auto view = std::as_bytes(std::span(words));
    key.assign(view.begin(), view.end());
    return validKey(kind, key);
  }
  kind = vertex ? KeyKind::Vertex : KeyKind::Fragment;
  return vertex ? parsed<gen::VertexKey>(words, key) : parsed<gen::FragmentKey>(words, key);
}

bool ShaderRow::current() const {
  return generator == generatorVersion();
}

std::vector<std::byte> ShaderRow::currentKey() const {
  if (current() || kind == KeyKind::VertexText || kind == KeyKind::FragmentText)
    return validKey(kind, key) ? key : std::vector<std::byte>{};
  KeyKind found;
  std::vector<std::byte> result;
  if (!keyOf(stageOf(kind), description, found, result) || found != kind) result.clear();
  return result;
}

ShaderRow makeRow(KeyKind kind, KeyBytes key, std::string glsl, std::vector<uint32_t> spirv,
                  int64_t compileMicroseconds) {
  ShaderRow row;
  row.kind = kind;
  row.key.assign(key.begin(), key.end());
  row.generator = generatorVersion();
  const bool own = kind == KeyKind::VertexText || kind == KeyKind::FragmentText;
  row.description = own ? fmt::format("the renderer's own {} shader",
                                      stageOf(kind) == gen::Stage::Vertex ? "vertex" : "fragment")
                        : wordsOf(kind, key);
  row.glsl = std::move(glsl);
  row.spirv = std::move(spirv);
  row.compileMicroseconds = compileMicroseconds;
  row.created = row.used = std::time(nullptr);
  row.uses = 1;
  return row;
}

int64_t PipelineRow::id() const {
  XXH64_hash_t hash = 0;
  for (const std::string* text : {&vertex, &fragment, &state})
    hash = XXH3_64bits_withSeed(text->data(), text->size(), hash);
  return static_cast<int64_t>(hash);
}

Program thisProgram() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string line{std::istreambuf_iterator<char>(file), {}};
  const size_t first = std::min(line.find('\0'), line.size());
  Program program;
  program.name = program_invocation_short_name;
  const std::string arguments = line.substr(first);
  const XXH64_hash_t seed = XXH3_64bits(program.name.data(), program.name.size());
  program.id = static_cast<int64_t>(XXH3_64bits_withSeed(arguments.data(), arguments.size(), seed));
  return program;
}

}  // namespace anteroom::cache
