#include "layer/cache/schema.h"

#include <fmt/format.h>

#include "layer/cache/generator_version.h"
#include "layer/cache/rows.h"

namespace anteroom::cache {
namespace {

constexpr int64_t kApplication = 0x414e5445;  // "ANTE"
constexpr int64_t kVersion = 2;

constexpr const char* kCreate =
    "CREATE TABLE shader("
    " number INTEGER PRIMARY KEY, id INTEGER NOT NULL, kind INTEGER NOT NULL, generator TEXT NOT NULL,"
    " created INTEGER NOT NULL, used INTEGER NOT NULL, uses INTEGER NOT NULL, compile_us INTEGER NOT NULL,"
    " checksum INTEGER NOT NULL, key BLOB NOT NULL, description TEXT NOT NULL, spirv BLOB NOT NULL,"
    " glsl TEXT NOT NULL);"
    "CREATE INDEX shader_used ON shader(used);"
    "CREATE TABLE pipeline("
    " id INTEGER PRIMARY KEY, created INTEGER NOT NULL, used INTEGER NOT NULL, uses INTEGER NOT NULL,"
    " create_us INTEGER NOT NULL, vertex TEXT NOT NULL, fragment TEXT NOT NULL, state TEXT NOT NULL);"
    "CREATE INDEX pipeline_used ON pipeline(used);"
    "CREATE TABLE program("
    " id INTEGER PRIMARY KEY, name TEXT NOT NULL, runs INTEGER NOT NULL, used INTEGER NOT NULL);"
    "CREATE TABLE usage("
    " program INTEGER NOT NULL, pipeline INTEGER NOT NULL, uses INTEGER NOT NULL, run INTEGER NOT NULL,"
    " place INTEGER NOT NULL, PRIMARY KEY(program, pipeline)) WITHOUT ROWID;"
    "PRAGMA application_id = 1095652421; PRAGMA user_version = 2;";
// Version 1 had no pipelines, and its rows' numbers were their keys'.
constexpr const char* kKeepVersion1 = "ALTER TABLE shader RENAME TO old; DROP INDEX shader_used;";
// (a | b) - (a & b) is a ^ b.
constexpr const char* kTakeVersion1 =
    "INSERT INTO shader(number, id, kind, generator, created, used, uses, compile_us, checksum, key, "
    "description,"
    " spirv, glsl) SELECT (id | {0}) - (id & {0}), id, kind, generator, created, used, uses, compile_us, "
    "checksum,"
    " key, description, spirv, glsl FROM old;"
    "DROP TABLE old;";

}  // namespace

SchemaState schemaState(Database& database) {
  const int64_t application = database.ask("PRAGMA application_id", -1);
  const int64_t version = database.ask("PRAGMA user_version", -1);
  if (application < 0 && version < 0) return SchemaState::Error;
  if (application == kApplication && version == kVersion) return SchemaState::Current;
  if (application == kApplication && version > kVersion) return SchemaState::Newer;
  if (application == kApplication && version == 1) return SchemaState::Older;
  const int64_t tables = database.ask("SELECT count(*) FROM sqlite_schema", -1);
  if (tables < 0) return SchemaState::Error;
  return tables > 0 || application != 0 ? SchemaState::Foreign : SchemaState::Empty;
}

int makeSchema(Database& database, SchemaState from) {
  const bool older = from == SchemaState::Older;
  int result = older ? database.run(kKeepVersion1) : SQLITE_OK;
  if (result == SQLITE_OK) result = database.run(kCreate);
  if (result == SQLITE_OK && older) {
    const int64_t generator = shaderNumber(0, generatorVersion());
    result = database.run(fmt::format(kTakeVersion1, generator).c_str());
  }
  return result;
}

}  // namespace anteroom::cache
