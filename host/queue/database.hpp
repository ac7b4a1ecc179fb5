// SPDX-License-Identifier: Apache-2.0
// SQLite with statements and transactions that end with their scope.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace queue {

// All calls throw std::runtime_error with SQLite's message. For one thread at a time.
class Database {
 public:
  // Made where it is missing. With its log (WAL) and synchronous=FULL a commit has reached the
  // disk when it returns.
  explicit Database(const std::filesystem::path& file);

  // Without results and values.
  void execute(const std::string& sql);
  std::int64_t last_id() const;
  std::int64_t changes() const;

 private:
  friend class Statement;
  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Closer> handle_;
};

class Statement {
 public:
  Statement(Database& database, const std::string& sql);

  // The next value, in the order of the question marks.
  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(std::string_view text);
  // To the next row of the result; false after the last one.
  bool step();
  // For a statement without results.
  void run();

  // Of the present row; columns count from 0.
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* handle) const;
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> handle_;
  int bound_ = 0;
};

// Undone at the end of its scope unless it was committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool committed_ = false;
};

}  // namespace queue
