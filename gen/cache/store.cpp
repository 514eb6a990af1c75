#include "gen/cache/store.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>
#include <ctime>
#include <filesystem>

#include "gen/cache/generator_version.h"
#include "gen/cache/spirv_check.h"

namespace anteroom::gen {
namespace {

constexpr int64_t kApplication = 0x414e5445;  // "ANTE"
constexpr int64_t kVersion = 1;
constexpr size_t kLongestText = 1 << 20;

constexpr const char* kSchema =
    "CREATE TABLE shader("
    "id INTEGER PRIMARY KEY, kind INTEGER NOT NULL, generator TEXT NOT NULL, created INTEGER NOT NULL,"
    "used INTEGER NOT NULL, uses INTEGER NOT NULL, compile_us INTEGER NOT NULL, checksum INTEGER NOT NULL,"
    "key BLOB NOT NULL, description TEXT NOT NULL, spirv BLOB NOT NULL, glsl TEXT NOT NULL);"
    "CREATE INDEX shader_used ON shader(used);"
    "PRAGMA application_id = 1095652421; PRAGMA user_version = 1;";
constexpr const char* kFind = "SELECT kind, generator, checksum, key, spirv FROM shader WHERE id = ?";
constexpr const char* kPut =
    "INSERT INTO shader(id, kind, generator, created, used, uses, compile_us, checksum, key, description, "
    "spirv,"
    " glsl) VALUES(?,?,?,?,?,?,?,?,?,?,?,?) ON CONFLICT(id) DO UPDATE SET kind = excluded.kind,"
    " generator = excluded.generator, created = excluded.created, used = max(used, excluded.used),"
    " uses = max(uses, excluded.uses), compile_us = excluded.compile_us, checksum = excluded.checksum,"
    " key = excluded.key, description = excluded.description, spirv = excluded.spirv, glsl = excluded.glsl";
constexpr const char* kTouch = "UPDATE shader SET uses = uses + 1, used = ? WHERE id = ?";
constexpr const char* kRemove = "DELETE FROM shader WHERE id = ?";
constexpr const char* kVisit =
    "SELECT id, kind, generator, created, used, uses, compile_us, checksum, key, description, spirv, glsl"
    " FROM shader";

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

// Bound to the row, so that a page which got lost elsewhere does not pass.
int64_t checksum(int64_t id, std::span<const std::byte> spirv) {
  return static_cast<int64_t>(XXH3_64bits_withSeed(spirv.data(), spirv.size(), static_cast<uint64_t>(id)));
}

std::string describeKey(KeyKind kind, KeyBytes key) {
  if (kind == KeyKind::Vertex) return describe(as<VertexKey>(key));
  if (kind == KeyKind::Fragment) return describe(as<FragmentKey>(key));
  return fmt::format("the renderer's own {} shader", stageOf(kind) == Stage::Vertex ? "vertex" : "fragment");
}

std::vector<uint32_t> words(std::span<const std::byte> bytes) {
  std::vector<uint32_t> result(bytes.size() / sizeof(uint32_t));
  std::memcpy(result.data(), bytes.data(), result.size() * sizeof(uint32_t));
  return result;
}

bool isDamage(int code) {
  return (code & 0xff) == SQLITE_CORRUPT || (code & 0xff) == SQLITE_NOTADB || (code & 0xff) == SQLITE_ERROR;
}

}  // namespace

int64_t rowId(KeyKind kind, KeyBytes key) {
  return static_cast<int64_t>(XXH3_64bits_withSeed(key.data(), key.size(), static_cast<uint64_t>(kind)));
}

bool validKey(KeyKind kind, KeyBytes key) {
  switch (kind) {
    case KeyKind::Vertex:
      return isValid<VertexKey>(key);
    case KeyKind::Fragment:
      return isValid<FragmentKey>(key);
    case KeyKind::VertexText:
    case KeyKind::FragmentText:
      return key.size() <= kLongestText && textOf(key).starts_with("#version");
  }
  return false;
}

std::string emit(KeyKind kind, KeyBytes key) {
  if (kind == KeyKind::Vertex) return emitVertex(as<VertexKey>(key));
  if (kind == KeyKind::Fragment) return emitFragment(as<FragmentKey>(key));
  return std::string(textOf(key));
}

Row makeRow(KeyKind kind, KeyBytes key, std::string glsl, std::vector<uint32_t> spirv,
            int64_t compileMicroseconds) {
  Row row;
  row.kind = kind;
  row.key.assign(key.begin(), key.end());
  row.generator = generatorVersion();
  row.description = describeKey(kind, key);
  row.glsl = std::move(glsl);
  row.spirv = std::move(spirv);
  row.compileMicroseconds = compileMicroseconds;
  row.created = row.used = std::time(nullptr);
  row.uses = 1;
  return row;
}

Opened Store::open(const std::string& path, Mode mode, int timeoutMilliseconds) {
  close();
  std::error_code ignored;
  if (mode != Mode::Create && !std::filesystem::exists(path, ignored)) return Opened::Missing;
  const int access = mode == Mode::Read    ? SQLITE_OPEN_READONLY
                     : mode == Mode::Write ? SQLITE_OPEN_READWRITE
                                           : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const int result = database_.open(path, access, timeoutMilliseconds);
  Opened opened = result == SQLITE_OK ? prepareSchema(mode == Mode::Create)
                  : isDamage(result)  ? Opened::Damaged
                                      : Opened::Unusable;
  if (opened == Opened::Ok) {
    int code = SQLITE_OK;
    find_ = database_.prepare(kFind, &code);
    if (code == SQLITE_OK) put_ = database_.prepare(kPut, &code);
    if (code == SQLITE_OK) touch_ = database_.prepare(kTouch, &code);
    if (code == SQLITE_OK) remove_ = database_.prepare(kRemove, &code);
    if (code != SQLITE_OK) opened = isDamage(code) ? Opened::Damaged : Opened::Unusable;
  }
  return opened;
}

Opened Store::prepareSchema(bool mayCreate) {
  const auto failed = [&] { return isDamage(database_.error()) ? Opened::Damaged : Opened::Unusable; };
  const auto state = [&]() -> std::optional<Opened> {
    const int64_t application = database_.ask("PRAGMA application_id", -1);
    const int64_t version = database_.ask("PRAGMA user_version", -1);
    if (application < 0 && version < 0) return failed();
    if (application == kApplication && version == kVersion) return Opened::Ok;
    if (application == kApplication && version > kVersion) return Opened::Newer;
    const int64_t tables = database_.ask("SELECT count(*) FROM sqlite_schema", -1);
    if (tables < 0) return failed();
    if (tables > 0 || application != 0) return Opened::Foreign;
    return {};  // nothing yet
  };
  // One snapshot: another process may be making the schema between two of these questions.
  if (database_.run("BEGIN") != SQLITE_OK) return failed();
  const auto found = state();
  if (found == Opened::Damaged || found == Opened::Unusable)
    return *found;  // with its message; closing rolls back
  rollback();
  if (found) return *found;
  if (!mayCreate) return Opened::Foreign;
  if (database_.run("PRAGMA journal_mode = WAL") != SQLITE_OK) return failed();
  if (database_.run("BEGIN IMMEDIATE") != SQLITE_OK) return failed();
  // Another process may have been faster.
  const auto known = state();
  if (!known && (database_.run(kSchema) != SQLITE_OK || !commit())) {
    const Opened why = failed();
    rollback();
    return why;
  }
  if (known) rollback();
  return known.value_or(Opened::Ok);
}

void Store::close() {
  for (Statement* statement : {&find_, &put_, &touch_, &remove_}) *statement = Statement();
  database_.close();
}

bool Store::damaged() const {
  return isDamage(database_.error());
}

bool Store::busy() const {
  return (database_.error() & 0xff) == SQLITE_BUSY || (database_.error() & 0xff) == SQLITE_LOCKED;
}

Found Store::find(KeyKind kind, KeyBytes key, std::vector<uint32_t>& spirv) {
  const int64_t id = rowId(kind, key);
  find_.bind(1, id);
  const int code = find_.step();
  Found found = code == SQLITE_DONE ? Found::Absent : Found::Error;
  if (code == SQLITE_ROW) {
    const auto stored = find_.blob(3), code_ = find_.blob(4);
    if (find_.number(0) != static_cast<int>(kind) || stored.size() != key.size() ||
        std::memcmp(stored.data(), key.data(), key.size()) != 0)
      found = Found::Bad;
    else if (find_.text(1) != generatorVersion())
      found = Found::Stale;
    else if (!plausibleSpirv(code_) || checksum(id, code_) != find_.number(2))
      found = Found::Bad;
    else
      found = Found::Hit;
    if (found == Found::Hit) spirv = words(code_);
  }
  find_.reset();
  return found;
}

bool Store::holdsCurrent() {
  Statement statement = database_.prepare("SELECT generator FROM shader LIMIT 1");
  return statement && statement.step() == SQLITE_ROW && statement.text(0) == generatorVersion();
}

bool Store::begin() {
  return database_.run("BEGIN IMMEDIATE") == SQLITE_OK;
}

bool Store::commit() {
  return database_.run("COMMIT") == SQLITE_OK;
}

void Store::rollback() {
  database_.run("ROLLBACK");
}

bool Store::put(const Row& row) {
  const int64_t id = row.id();
  const auto spirv = std::as_bytes(std::span(row.spirv));
  const int64_t numbers[] = {row.created, row.used, row.uses, row.compileMicroseconds, checksum(id, spirv)};
  put_.bind(1, id);
  put_.bind(2, static_cast<int64_t>(row.kind));
  put_.bind(3, std::string_view(row.generator));
  for (int i = 0; i < 5; ++i) put_.bind(4 + i, numbers[i]);
  put_.bind(9, std::span<const std::byte>(row.key));
  put_.bind(10, std::string_view(row.description));
  put_.bind(11, spirv);
  put_.bind(12, std::string_view(row.glsl));
  const int code = put_.step();
  put_.reset();
  return code == SQLITE_DONE;
}

bool Store::touch(int64_t id, int64_t now) {
  touch_.bind(1, now);
  touch_.bind(2, id);
  const int code = touch_.step();
  touch_.reset();
  return code == SQLITE_DONE;
}

bool Store::remove(int64_t id) {
  remove_.bind(1, id);
  const int code = remove_.step();
  remove_.reset();
  return code == SQLITE_DONE;
}

int64_t Store::shrink(uint64_t bytes) {
  const auto used = [&] {
    const int64_t pages = database_.ask("PRAGMA page_count", 0) - database_.ask("PRAGMA freelist_count", 0);
    return static_cast<uint64_t>(pages * database_.ask("PRAGMA page_size", 0));
  };
  int64_t dropped = 0;
  while (used() > bytes) {
    if (database_.run("DELETE FROM shader WHERE id IN (SELECT id FROM shader ORDER BY used LIMIT"
                      " 1 + (SELECT count(*) FROM shader) / 8)") != SQLITE_OK)
      return -1;
    if (database_.changes() == 0) break;
    dropped += database_.changes();
  }
  return dropped;
}

bool Store::visit(const Visit& visit) {
  Statement statement = database_.prepare(kVisit);
  if (!statement) return false;
  int code;
  while ((code = statement.step()) == SQLITE_ROW) {
    const int64_t id = statement.number(0), kind = statement.number(1);
    const auto key = statement.blob(8), spirv = statement.blob(10);
    Row row;
    row.kind = static_cast<KeyKind>(kind & 3);
    row.key.assign(key.begin(), key.end());
    row.generator = statement.text(2);
    row.created = statement.number(3);
    row.used = statement.number(4);
    row.uses = statement.number(5);
    row.compileMicroseconds = statement.number(6);
    row.description = statement.text(9);
    row.spirv = words(spirv);
    row.glsl = statement.text(11);
    std::string why;
    if (kind < 0 || kind > 3)
      why = "its kind is unknown";
    else if (!validKey(row.kind, key))
      why = "its key is none that this version makes";
    else if (row.id() != id)
      why = "its number is not that of its key";
    else if (!plausibleSpirv(spirv))
      why = "its SPIR-V is no SPIR-V";
    else if (checksum(id, spirv) != statement.number(7))
      why = "its SPIR-V does not match its checksum";
    visit(id, row, why);
  }
  return code == SQLITE_DONE;
}

}  // namespace anteroom::gen
