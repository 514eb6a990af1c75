#include "layer/cache/database.h"

namespace anteroom::cache {
namespace {

constexpr int kLongestValue = 4 << 20;

}  // namespace

void Statement::reset() {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

bool Statement::run() {
  int code;
  while ((code = step()) == SQLITE_ROW) continue;
  reset();
  return code == SQLITE_DONE;
}

void Statement::bind(int i, std::string_view text) {
  sqlite3_bind_text(statement_.get(), i, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
}

void Statement::bind(int i, std::span<const std::byte> blob) {
  sqlite3_bind_blob(statement_.get(), i, blob.data(), static_cast<int>(blob.size()), SQLITE_STATIC);
}

std::string_view Statement::text(int i) {
  const auto bytes = blob(i);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const std::byte> Statement::blob(int i) {
  const void* const data = sqlite3_column_blob(statement_.get(), i);
  if (!data) return {};
  return {static_cast<const std::byte*>(data),
          static_cast<size_t>(sqlite3_column_bytes(statement_.get(), i))};
}

int Database::open(const std::string& path, int flags, int timeout) {
  sqlite3* made = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &made, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(made);
  if (result != SQLITE_OK) return result;
  sqlite3_busy_timeout(made, timeout);
  sqlite3_limit(made, SQLITE_LIMIT_LENGTH, kLongestValue);
  sqlite3_db_config(made, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(made, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(made, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(made, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  return run("PRAGMA cell_size_check = ON; PRAGMA synchronous = NORMAL; PRAGMA temp_store = MEMORY;");
}

int Database::run(const char* sql) {
  return handle_ ? sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr) : SQLITE_NOMEM;
}

int64_t Database::ask(const char* sql, int64_t otherwise) {
  Statement statement = prepare(sql);
  return statement && statement.step() == SQLITE_ROW ? statement.number(0) : otherwise;
}

Statement Database::prepare(const char* sql, int* result) {
  sqlite3_stmt* made = nullptr;
  const int code = handle_
                       ? sqlite3_prepare_v3(handle_.get(), sql, -1, SQLITE_PREPARE_PERSISTENT, &made, nullptr)
                       : SQLITE_NOMEM;
  if (result) *result = code;
  Statement statement;
  statement.statement_.reset(made);
  return statement;
}

}  // namespace anteroom::cache
