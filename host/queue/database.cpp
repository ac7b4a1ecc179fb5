// SPDX-License-Identifier: Apache-2.0
// Calls of SQLite's C interface.
#include "host/queue/database.hpp"

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

}  // namespace

void Database::Closer::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
void Statement::Finalizer::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

Database::Database(const std::filesystem::path& file) {
  sqlite3* handle = nullptr;
  const int status =
      sqlite3_open_v2(file.c_str(), &handle,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(handle);
  if (status != SQLITE_OK) fail(handle);
  sqlite3_busy_timeout(handle, patience_ms);
  Statement mode(*this, "PRAGMA journal_mode=WAL");
  if (!mode.step() || mode.text(0) != "wal") {
    throw std::runtime_error("job database: no write-ahead log is possible in " +
                             file.parent_path().string());
  }
  // SQLite does not see to it that the removal of the journal with which it began the log is on the
  // disk. A loss of power would bring it back, and undo the whole database with it.
  sync_folder(std::filesystem::absolute(file).parent_path());
  execute("PRAGMA synchronous=FULL");
  execute("PRAGMA foreign_keys=ON");
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail(handle_.get());
  }
}

std::int64_t Database::last_id() const { return sqlite3_last_insert_rowid(handle_.get()); }
std::int64_t Database::changes() const { return sqlite3_changes64(handle_.get()); }

Statement::Statement(Database& database, const std::string& sql)
    : database_(database.handle_.get()) {
  sqlite3_stmt* handle = nullptr;
  if (sqlite3_prepare_v2(database_, sql.c_str(), -1, &handle, nullptr) != SQLITE_OK) {
    fail(database_);
  }
  handle_.reset(handle);
}

Statement& Statement::bind(std::int64_t value) {
  if (sqlite3_bind_int64(handle_.get(), ++bound_, value) != SQLITE_OK) fail(database_);
  return *this;
}

Statement& Statement::bind(double value) {
  if (sqlite3_bind_double(handle_.get(), ++bound_, value) != SQLITE_OK) fail(database_);
  return *this;
}

Statement& Statement::bind(std::string_view text) {
  if (sqlite3_bind_text64(handle_.get(), ++bound_, text.data(), text.size(), SQLITE_TRANSIENT,
                          SQLITE_UTF8) != SQLITE_OK) {
    fail(database_);
  }
  return *this;
}

bool Statement::step() {
  const int status = sqlite3_step(handle_.get());
  if (status != SQLITE_ROW && status != SQLITE_DONE) fail(database_);
  return status == SQLITE_ROW;
}

void Statement::run() {
  while (step()) {
  }
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}
double Statement::real(int column) const { return sqlite3_column_double(handle_.get(), column); }
std::string Statement::text(int column) const {
  const void* text = sqlite3_column_blob(handle_.get(), column);
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return text == nullptr
             ? std::string()
             : std::string(static_cast<const char*>(text), static_cast<std::size_t>(size));
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (committed_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const std::exception&) {  // SQLite has rolled it back by itself
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  committed_ = true;
}

}  // namespace queue
