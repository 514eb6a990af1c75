// The file of the shader cache: rows, and whether they can be believed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gen/cache/database.h"
#include "gen/gen.h"

namespace anteroom::gen {

// What a row's key is: the bytes of a VertexKey or FragmentKey, or, for shaders that no key makes, their
// GLSL.
enum class KeyKind : uint8_t { Vertex, Fragment, VertexText, FragmentText };
constexpr Stage stageOf(KeyKind kind) {
  return kind == KeyKind::Vertex || kind == KeyKind::VertexText ? Stage::Vertex : Stage::Fragment;
}

using KeyBytes = std::span<const std::byte>;
template <class Key>
KeyBytes bytesOf(const Key& key) {
  return std::as_bytes(std::span(&key, 1));
}

// The number of a row: durable, and the same on every machine.
int64_t rowId(KeyKind kind, KeyBytes key);

struct Row {
  KeyKind kind = KeyKind::Vertex;
  std::vector<std::byte> key;
  std::string generator, description, glsl;
  std::vector<uint32_t> spirv;
  int64_t compileMicroseconds = 0;
  int64_t created = 0, used = 0;  // seconds since 1970
  int64_t uses = 0;               // by how many processes

  int64_t id() const { return rowId(kind, key); }
};

// Fills in generator version and description; the times are now.
Row makeRow(KeyKind kind, KeyBytes key, std::string glsl, std::vector<uint32_t> spirv,
            int64_t compileMicroseconds);
// The key must be valid.
std::string emit(KeyKind kind, KeyBytes key);
bool validKey(KeyKind kind, KeyBytes key);

enum class Opened { Ok, Missing, Foreign, Newer, Damaged, Unusable };
enum class Found { Hit, Absent, Stale, Bad, Error };

// One connection, for one thread at a time.
class Store {
 public:
  enum class Mode { Read, Write, Create };
  Opened open(const std::string& path, Mode mode, int timeoutMilliseconds = 100);
  void close();
  bool isOpen() const { return static_cast<bool>(database_); }
  std::string message() const { return database_.message(); }
  // The file itself, not a row, cannot be read.
  bool damaged() const;
  // Another process has it locked.
  bool busy() const;

  // Stale: made by another generator. Error: ask damaged().
  Found find(KeyKind kind, KeyBytes key, std::vector<uint32_t>& spirv);
  // Whether the file seems to hold shaders of this generator.
  bool holdsCurrent();

  // A transaction; false rolls all of it back.
  bool begin();
  bool commit();
  void rollback();
  bool put(const Row& row);
  // One more process used the row.
  bool touch(int64_t id, int64_t now);
  bool remove(int64_t id);
  // Drops the rows unused for longest until the file's contents fit `bytes`. The number of rows, or -1.
  int64_t shrink(uint64_t bytes);

  // `why` is empty for a good row; else it says what is wrong, and `row` holds what could be read. False: the
  // file could not be read to its end.
  using Visit = std::function<void(int64_t id, Row& row, const std::string& why)>;
  bool visit(const Visit& visit);
  Database& database() { return database_; }

 private:
  Opened prepareSchema(bool mayCreate);

  Database database_;
  Statement find_, put_, touch_, remove_;
};

}  // namespace anteroom::gen
