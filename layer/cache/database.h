// SQLite with owners. Result codes are SQLite's own.
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace anteroom::cache {

class Statement {
 public:
  Statement() = default;
  // One row, or the end: SQLITE_ROW, SQLITE_DONE, or an error.
  int step() { return sqlite3_step(statement_.get()); }
  void reset();
  // All of it, ready for the next time. False: an error.
  bool run();
  explicit operator bool() const { return statement_ != nullptr; }

  // Bound memory must outlive the step. Numbers of parameters begin at 1.
  void bind(int i, int64_t value) { sqlite3_bind_int64(statement_.get(), i, value); }
  void bind(int i, std::string_view text);
  void bind(int i, std::span<const std::byte> blob);

  // Columns begin at 0. Views last until the next step or reset.
  int64_t number(int i) { return sqlite3_column_int64(statement_.get(), i); }
  std::string_view text(int i);
  std::span<const std::byte> blob(int i);

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

// One connection, for one thread at a time. What the file says is not trusted.
class Database {
 public:
  // flags: SQLITE_OPEN_*. Waits for other processes at most `timeout` milliseconds at each step.
  int open(const std::string& path, int flags, int timeout);
  void close() { handle_.reset(); }
  explicit operator bool() const { return handle_ != nullptr; }

  int run(const char* sql);
  // The first column of the first row, as a number; `otherwise` when there is none.
  int64_t ask(const char* sql, int64_t otherwise);
  Statement prepare(const char* sql, int* result = nullptr);
  int error() const { return handle_ ? sqlite3_errcode(handle_.get()) : SQLITE_NOMEM; }
  std::string message() const { return handle_ ? sqlite3_errmsg(handle_.get()) : "out of memory"; }
  int changes() const { return sqlite3_changes(handle_.get()); }

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace anteroom::cache
