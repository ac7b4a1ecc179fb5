// SPDX-License-Identifier: Apache-2.0
// Each transaction leaves a mark with its commit, by which its outcome is known afterwards.
#include "host/queue/postgres_database.hpp"

#include <charconv>
#include <thread>
#include <utility>

#include "host/queue/postgres_tables.hpp"
#include "host/queue/random_name.hpp"
#include "host/queue/valid_text.hpp"

namespace queue {

namespace {

constexpr pqxx::oid int4_type = 23, int8_type = 20, float8_type = 701;

// $1, $2 … for question marks; no text of the queue's statements has one.
std::string numbered(const std::string& sql) {
  std::string text;
  for (int number = 0; const char c : sql) {
    text += c == '?' ? "$" + std::to_string(++number) : std::string(1, c);
  }
  return text;
}

pqxx::params params_of(const std::vector<Value>& values) {
  pqxx::params params;
  for (const Value& value : values) {
    if (const auto* text = std::get_if<std::string>(&value)) {
      params.append(valid_text(*text));
    } else {
      std::visit([&](const auto& number) { params.append(number); }, value);
    }
  }
  return params;
}

Value value_of(const pqxx::field& field) {
  switch (field.type()) {
    case int4_type:
    case int8_type:
      return field.as<std::int64_t>();
    case float8_type:
      return field.as<double>();
    default:
      return std::string(field.view());
  }
}

}  // namespace

PostgresDatabase::PostgresDatabase(const std::string& address)
    : connection_(address), session_(random_name()) {
  connection_.connect();
  make_postgres_tables(connection_);
}

void PostgresDatabase::execute(const std::string& sql) {
  if (!in_transaction_) connection_.connect();
  connection_.execute(sql);
}

Result PostgresDatabase::run(const std::string& sql, const std::vector<Value>& values) {
  // In a transaction, what a new connection does would not belong to it.
  if (!in_transaction_) connection_.connect();
  const pqxx::result found = connection_.call(
      [&](pqxx::nontransaction& work) { return work.exec(numbered(sql), params_of(values)); });
  Result result;
  for (const pqxx::row& row : found) {
    std::vector<Value>& values_of_row = result.rows.emplace_back();
    for (const pqxx::field& field : row) values_of_row.push_back(value_of(field));
  }
  result.changes = found.affected_rows();
  return result;
}

void PostgresDatabase::begin() {
  connection_.connect();
  try {
    connection_.execute("BEGIN; SELECT pg_advisory_xact_lock(" + std::to_string(queue_lock) + ")");
  } catch (...) {
    roll_back();
    throw;
  }
  in_transaction_ = true;
}

void PostgresDatabase::commit() {
  const std::string mark = session_ + " " + std::to_string(++commits_);
  run("INSERT INTO sessions(id, mark) VALUES(?, ?) "
      "ON CONFLICT(id) DO UPDATE SET mark = excluded.mark, at = now()",
      {session_, mark});
  try {
    connection_.execute("COMMIT");
    in_transaction_ = false;
  } catch (const Unavailable&) {
    in_transaction_ = false;
    if (!was_committed(mark)) {
      throw Unavailable("the connection to the queue's database was lost before the commit");
    }
  }
}

// The server may still be at it: the lock that begin() waits for is only free when the old
// transaction is over, so that what is found then does not change any more.
bool PostgresDatabase::was_committed(const std::string& mark) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    try {
      begin();
      const Result found = run("SELECT mark FROM sessions WHERE id = ?", {session_});
      roll_back();
      return !found.rows.empty() && found.rows[0].at(0) == Value(mark);
    } catch (const Unavailable& error) {
      roll_back();
      if (std::chrono::steady_clock::now() >= end) {
        throw OutcomeUnknown(std::string("it is not known whether it was committed; ") +
                             error.what());
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

void PostgresDatabase::roll_back() noexcept {
  in_transaction_ = false;
  try {
    if (connection_.is_open()) connection_.execute("ROLLBACK");
  } catch (const std::exception&) {  // with the connection, the server ends its transaction
  }
}

}  // namespace queue
