// SPDX-License-Identifier: Apache-2.0
// Calls of SQLite's C interface.
#include "host/queue/sqlite_database.hpp"

#include <sqlite3.h>

#include <stdexcept>

#include "host/queue/store.hpp"

namespace queue {

namespace {

[[noreturn]] void fail(sqlite3* handle) {
  throw std::runtime_error(std::string("job database: ") +
                           (handle == nullptr ? "no memory" : sqlite3_errmsg(handle)));
}

constexpr int patience_ms = 5000;  // for another program that reads the file

struct Finalizer {
  void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
};
using Prepared = std::unique_ptr<sqlite3_stmt, Finalizer>;

struct Binder {
  sqlite3_stmt* statement;
  int place;
  int operator()(std::int64_t value) const { return sqlite3_bind_int64(statement, place, value); }
  int operator()(double value) const { return sqlite3_bind_double(statement, place, value); }
  int operator()(const std::string& text) const {
    return sqlite3_bind_text64(statement, place, text.data(), text.size(), SQLITE_STATIC,
                               SQLITE_UTF8);
  }
};

Value value_of(sqlite3_stmt* row, int column) {
  switch (sqlite3_column_type(row, column)) {
    case SQLITE_INTEGER:
      return sqlite3_column_int64(row, column);
    case SQLITE_FLOAT:
      return sqlite3_column_double(row, column);
    default: {
      const void* text = sqlite3_column_blob(row, column);
      const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, column));
      return text == nullptr ? std::string() : std::string(static_cast<const char*>(text), size);
    }
  }
}

}  // namespace

void SqliteDatabase::Closer::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

SqliteDatabase::SqliteDatabase(const std::filesystem::path& file) {
  sqlite3* handle = nullptr;
  const int status =
      sqlite3_open_v2(file.c_str(), &handle,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(handle);
  if (status != SQLITE_OK) fail(handle);
  sqlite3_busy_timeout(handle, patience_ms);
  const Result mode = run("PRAGMA journal_mode=WAL", {});
  if (mode.rows.empty() || mode.rows[0].at(0) != Value("wal")) {
    throw std::runtime_error("job database: no write-ahead log is possible in " +
                             file.parent_path().string());
  }
  // SQLite does not see to it that the removal of the journal with which it began the log is on the
  // disk. A loss of power would bring it back, and undo the whole database with it.
  sync_folder(std::filesystem::absolute(file).parent_path());
  execute("PRAGMA synchronous=FULL");
  execute("PRAGMA foreign_keys=ON");
}

void SqliteDatabase::execute(const std::string& sql) {
  if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail(handle_.get());
  }
}

Result SqliteDatabase::run(const std::string& sql, const std::vector<Value>& values) {
  sqlite3_stmt* handle = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql.c_str(), -1, &handle, nullptr) != SQLITE_OK) {
    fail(handle_.get());
  }
  const Prepared statement(handle);
  for (int place = 1; const Value& value : values) {
    if (std::visit(Binder{handle, place++}, value) != SQLITE_OK) fail(handle_.get());
  }
  Result result;
  int status = SQLITE_ROW;
  while ((status = sqlite3_step(handle)) == SQLITE_ROW) {
    std::vector<Value>& row = result.rows.emplace_back();
    for (int i = 0; i < sqlite3_column_count(handle); ++i) row.push_back(value_of(handle, i));
  }
  if (status != SQLITE_DONE) fail(handle_.get());
  result.changes = sqlite3_changes64(handle_.get());
  return result;
}

// IMMEDIATE: the lock is taken at once, not with the first write.
void SqliteDatabase::begin() { execute("BEGIN IMMEDIATE"); }
void SqliteDatabase::commit() { execute("COMMIT"); }

void SqliteDatabase::roll_back() noexcept {
  // Where this fails, SQLite has rolled it back by itself.
  sqlite3_exec(handle_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

}  // namespace queue
