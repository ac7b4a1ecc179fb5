// SPDX-License-Identifier: Apache-2.0
// Statements and transactions of a database; SQLite and PostgreSQL are behind it.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace queue {

// The database cannot be reached, or does not answer in time. Nothing was changed.
struct Unavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};
// The connection was lost in a commit, and whether it was made could not be found out yet.
struct OutcomeUnknown : Unavailable {
  using Unavailable::Unavailable;
};

using Value = std::variant<std::int64_t, double, std::string>;
struct Result {
  std::vector<std::vector<Value>> rows;
  std::int64_t changes = 0;  // rows inserted, updated or deleted
};

// For one thread at a time. All calls throw std::runtime_error with the database's message, or
// Unavailable, which is one.
class Database {
 public:
  Database() = default;
  virtual ~Database() = default;
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  // Any number of statements, without results and values.
  virtual void execute(const std::string& sql) = 0;
  // One statement; a value for each question mark.
  virtual Result run(const std::string& sql, const std::vector<Value>& values) = 0;

 private:
  friend class Transaction;
  // From here to the end no other program writes, so what is read stays true.
  virtual void begin() = 0;
  // It has reached the disk when it returns. Also throws OutcomeUnknown.
  virtual void commit() = 0;
  virtual void roll_back() noexcept = 0;
};

class Statement {
 public:
  Statement(Database& database, std::string sql) : database_(database), sql_(std::move(sql)) {}

  // The next value, in the order of the question marks.
  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(std::string_view text);
  // To the next row of the result; false after the last one. The first call runs it.
  bool step();
  // For a statement without results: how many rows it has changed.
  std::int64_t run();

  // Of the present row; columns count from 0.
  std::int64_t integer(std::size_t column) const;
  double real(std::size_t column) const;
  const std::string& text(std::size_t column) const;

 private:
  Database& database_;
  std::string sql_;
  std::vector<Value> values_;
  Result result_;
  std::size_t next_ = 0;  // row; 0: it has not run
};

// Undone at the end of its scope unless it was committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  // Whatever comes of it, it cannot be tried again.
  void commit();

 private:
  Database& database_;
  bool over_ = false;
};

}  // namespace queue
