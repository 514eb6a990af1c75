#include "layer/cache/store.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <initializer_list>

#include "layer/cache/generator_version.h"
#include "layer/cache/schema.h"
#include "layer/cache/spirv_check.h"

namespace anteroom::cache {
namespace {

constexpr const char* kFind = "SELECT kind, generator, checksum, key, spirv FROM shader WHERE number = ?";
constexpr const char* kPut =
    "INSERT INTO shader(number, id, kind, generator, created, used, uses, compile_us, checksum, key, "
    "description,"
    " spirv, glsl) VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?) ON CONFLICT(number) DO UPDATE SET id = excluded.id,"
    " kind = excluded.kind, generator = excluded.generator, created = excluded.created,"
    " used = max(used, excluded.used), uses = max(uses, excluded.uses), compile_us = excluded.compile_us,"
    " checksum = excluded.checksum, key = excluded.key, description = excluded.description,"
    " spirv = excluded.spirv, glsl = excluded.glsl";
constexpr const char* kTouch = "UPDATE shader SET uses = uses + 1, used = ? WHERE number = ?";
constexpr const char* kVisit =
    "SELECT number, id, kind, generator, created, used, uses, compile_us, checksum, key, description, spirv, "
    "glsl"
    " FROM shader";

// Bound to the row, so that a page which got lost elsewhere does not pass.
int64_t checksum(int64_t id, std::span<const std::byte> spirv) {
  return static_cast<int64_t>(XXH3_64bits_withSeed(spirv.data(), spirv.size(), static_cast<uint64_t>(id)));
}

std::vector<uint32_t> words(std::span<const std::byte> bytes) {
  std::vector<uint32_t> result(bytes.size() / sizeof(uint32_t));
  if (!result.empty()) std::memcpy(result.data(), bytes.data(), result.size() * sizeof(uint32_t));
  return result;
}

bool isDamage(int code) {
  return (code & 0xff) == SQLITE_CORRUPT || (code & 0xff) == SQLITE_NOTADB || (code & 0xff) == SQLITE_ERROR;
}

std::string faultOf(const ShaderRow& row, int64_t kind, int64_t id, std::span<const std::byte> spirv,
                    int64_t sum) {
  if (kind < 0 || kind > 3) return "its kind is unknown";
  if (row.id() != id) return "its number is not that of its key";
  if (row.current() && !validKey(row.kind, row.key)) return "its key is none that this version makes";
  if (!plausibleSpirv(spirv)) return "its SPIR-V is no SPIR-V";
  if (checksum(id, spirv) != sum) return "its SPIR-V does not match its checksum";
  return {};
}

}  // namespace

Opened Store::open(const std::string& path, Mode mode, int timeoutMilliseconds) {
  close();
  std::error_code ignored;
  if (mode != Mode::Create && !std::filesystem::exists(path, ignored)) return Opened::Missing;
  const int access = mode == Mode::Read    ? SQLITE_OPEN_READONLY
                     : mode == Mode::Write ? SQLITE_OPEN_READWRITE
                                           : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const int result = database_.open(path, access, timeoutMilliseconds);
  Opened opened = result == SQLITE_OK ? prepareSchema(mode)
                  : isDamage(result)  ? Opened::Damaged
                                      : Opened::Unusable;
  if (opened == Opened::Ok) {
    int code = SQLITE_OK;
    find_ = database_.prepare(kFind, &code);
    if (code == SQLITE_OK) put_ = database_.prepare(kPut, &code);
    if (code == SQLITE_OK) touch_ = database_.prepare(kTouch, &code);
    if (code != SQLITE_OK) opened = isDamage(code) ? Opened::Damaged : Opened::Unusable;
  }
  return opened;
}

Opened Store::prepareSchema(Mode mode) {
  const auto failed = [&] { return damaged() ? Opened::Damaged : Opened::Unusable; };
  const auto changes = [&](SchemaState state) {
    return (state == SchemaState::Empty && mode == Mode::Create) ||
           (state == SchemaState::Older && mode != Mode::Read);
  };
  const auto openedAs = [](SchemaState state) {
    switch (state) {
      case SchemaState::Current:
        return Opened::Ok;
      case SchemaState::Older:
        return Opened::Older;
      case SchemaState::Newer:
        return Opened::Newer;
      default:
        return Opened::Foreign;
    }
  };
  // One snapshot: another process may be making the schema between two of the questions.
  if (database_.run("BEGIN") != SQLITE_OK) return failed();
  SchemaState state = schemaState(database_);
  if (state == SchemaState::Error) return failed();  // with its message; closing rolls back
  rollback();
  if (!changes(state)) return openedAs(state);
  if (database_.run("PRAGMA journal_mode = WAL") != SQLITE_OK) return failed();
  if (database_.run("BEGIN IMMEDIATE") != SQLITE_OK) return failed();
  // Another process may have been faster.
  state = schemaState(database_);
  if (changes(state)) {
    if (makeSchema(database_, state) == SQLITE_OK && commit()) return Opened::Ok;
    const Opened why = failed();
    rollback();
    return why;
  }
  if (state == SchemaState::Error) return failed();
  rollback();
  return openedAs(state);
}

void Store::close() {
  for (Statement* statement :
       {&find_, &put_, &touch_, &putPipeline_, &touchPipeline_, &use_, &putUsage_, &putProgram_})
    *statement = Statement();
  database_.close();
}

bool Store::damaged() const {
  return isDamage(database_.error());
}

bool Store::busy() const {
  return (database_.error() & 0xff) == SQLITE_BUSY || (database_.error() & 0xff) == SQLITE_LOCKED;
}

Statement& Store::lazily(Statement& statement, const char* sql) {
  if (!statement) statement = database_.prepare(sql);
  return statement;
}

Found Store::find(KeyKind kind, KeyBytes key, std::vector<uint32_t>& spirv) {
  const int64_t id = shaderId(kind, key);
  find_.bind(1, shaderNumber(id, generatorVersion()));
  const int code = find_.step();
  Found found = code == SQLITE_DONE ? Found::Absent : Found::Error;
  if (code == SQLITE_ROW) {
    const auto stored = find_.blob(3), code_ = find_.blob(4);
    const bool same = find_.number(0) == static_cast<int>(kind) && find_.text(1) == generatorVersion() &&
                      std::equal(stored.begin(), stored.end(), key.begin(), key.end());
    found = same && plausibleSpirv(code_) && checksum(id, code_) == find_.number(2) ? Found::Hit : Found::Bad;
    if (found == Found::Hit) spirv = words(code_);
  }
  find_.reset();
  return found;
}

bool Store::holdsCurrent() {
  Statement statement = database_.prepare(
      "SELECT 1 FROM (SELECT generator FROM shader ORDER BY used DESC LIMIT 16) WHERE generator = ?");
  if (!statement) return false;
  statement.bind(1, generatorVersion());
  return statement.step() == SQLITE_ROW;
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

bool Store::put(const ShaderRow& row) {
  const int64_t id = row.id();
  const auto spirv = std::as_bytes(std::span(row.spirv));
  const int64_t numbers[] = {row.created, row.used, row.uses, row.compileMicroseconds, checksum(id, spirv)};
  put_.bind(1, shaderNumber(id, row.generator));
  put_.bind(2, id);
  put_.bind(3, static_cast<int64_t>(row.kind));
  put_.bind(4, std::string_view(row.generator));
  for (int i = 0; i < 5; ++i) put_.bind(5 + i, numbers[i]);
  put_.bind(10, std::span<const std::byte>(row.key));
  put_.bind(11, std::string_view(row.description));
  put_.bind(12, spirv);
  put_.bind(13, std::string_view(row.glsl));
  return put_.run();
}

bool Store::touch(int64_t id, int64_t now) {
  touch_.bind(1, now);
  touch_.bind(2, shaderNumber(id, generatorVersion()));
  return touch_.run();
}

bool Store::removeShader(int64_t number) {
  Statement statement = database_.prepare("DELETE FROM shader WHERE number = ?");
  if (!statement) return false;
  statement.bind(1, number);
  return statement.run();
}

int64_t Store::shrink(uint64_t bytes) {
  const auto used = [&] {
    const int64_t pages = database_.ask("PRAGMA page_count", 0) - database_.ask("PRAGMA freelist_count", 0);
    return static_cast<uint64_t>(pages * database_.ask("PRAGMA page_size", 0));
  };
  int64_t dropped = 0, before = -1;
  while (used() > bytes && dropped != before) {
    before = dropped;
    for (const char* sql :
         {"DELETE FROM shader WHERE number IN (SELECT number FROM shader ORDER BY used LIMIT"
          " 1 + (SELECT count(*) FROM shader) / 8)",
          "DELETE FROM pipeline WHERE id IN (SELECT id FROM pipeline ORDER BY used LIMIT"
          " 1 + (SELECT count(*) FROM pipeline) / 8)"}) {
      if (database_.run(sql) != SQLITE_OK) return -1;
      dropped += database_.changes();
    }
  }
  return dropped == 0 || dropUsageOfNone() ? dropped : -1;
}

bool Store::visitShaders(const VisitShader& visit) {
  Statement statement = database_.prepare(kVisit);
  if (!statement) return false;
  int code;
  while ((code = statement.step()) == SQLITE_ROW) {
    const int64_t id = statement.number(1), kind = statement.number(2);
    const auto key = statement.blob(9), spirv = statement.blob(11);
    ShaderRow row;
    row.kind = static_cast<KeyKind>(kind & 3);
    row.key.assign(key.begin(), key.end());
    row.generator = statement.text(3);
    row.created = statement.number(4);
    row.used = statement.number(5);
    row.uses = statement.number(6);
    row.compileMicroseconds = statement.number(7);
    row.description = statement.text(10);
    row.spirv = words(spirv);
    row.glsl = statement.text(12);
    visit(statement.number(0), id, row, faultOf(row, kind, id, spirv, statement.number(8)));
  }
  return code == SQLITE_DONE;
}

}  // namespace anteroom::cache
