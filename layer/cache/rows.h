// What the cache holds: shaders, pipelines, and which program needed which pipeline.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gen/gen.h"

namespace anteroom::cache {

// What a shader's key is: the bytes of a gen::VertexKey or FragmentKey, or, for shaders that no key makes, their
// GLSL.
enum class KeyKind : uint8_t { Vertex, Fragment, VertexText, FragmentText };
constexpr gen::Stage stageOf(KeyKind kind) {
  return kind == KeyKind::Vertex || kind == KeyKind::VertexText ? gen::Stage::Vertex : gen::Stage::Fragment;
}

using KeyBytes = std::span<const std::byte>;
template <class Key>
KeyBytes bytesOf(const Key& key) {
  return std::as_bytes(std::span(&key, 1));
}

// The name of a shader: the same on every machine. Keys whose layout changes get other names.
int64_t shaderId(KeyKind kind, KeyBytes key);
// Of its row: one a generator.
int64_t shaderNumber(int64_t id, std::string_view generator);
// The key must be valid.
std::string emit(KeyKind kind, KeyBytes key);
bool validKey(KeyKind kind, KeyBytes key);

// A key as text that no generator's layout of keys changes: in words, or GLSL.
std::string wordsOf(KeyKind kind, KeyBytes key);
// And back. False: this generator makes no such key.
bool keyOf(gen::Stage stage, const std::string& words, KeyKind& kind, std::vector<std::byte>& key);

struct ShaderRow {
  KeyKind kind = KeyKind::Vertex;
  std::vector<std::byte> key;  // as its generator lays keys out
  std::string generator, description, glsl;
  std::vector<uint32_t> spirv;
  int64_t compileMicroseconds = 0;
  int64_t created = 0, used = 0;  // seconds since 1970
  int64_t uses = 0;               // by how many processes

  int64_t id() const { return shaderId(kind, key); }
  // Of the generator that asks.
  bool current() const;
  // As this generator lays keys out. Empty: it makes no such key.
  std::vector<std::byte> currentKey() const;
};

// Fills in generator version and description; the times are now.
ShaderRow makeRow(KeyKind kind, KeyBytes key, std::string glsl, std::vector<uint32_t> spirv,
                  int64_t compileMicroseconds);

// Text throughout, and so the same for every generator.
struct PipelineRow {
  std::string vertex, fragment;  // wordsOf() the shaders
  std::string state;             // the renderer's words for the rest
  int64_t createMicroseconds = 0;
  int64_t created = 0, used = 0;
  int64_t uses = 0;

  int64_t id() const;
};

// A program as it was called: its file's name and its arguments, but not where the file is.
struct Program {
  int64_t id = 0;
  std::string name;  // of the file
};
Program thisProgram();

struct UsageRow {
  Program program;
  int64_t runs = 0;      // of the program
  int64_t pipeline = 0;  // PipelineRow::id
  int64_t uses = 0;      // in how many runs
  int64_t run = 0;       // the last of these
  int64_t place = 0;     // in the order of first use
};

}  // namespace anteroom::cache
