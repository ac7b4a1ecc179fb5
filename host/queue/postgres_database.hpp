// SPDX-License-Identifier: Apache-2.0
// The queue's statements on a PostgreSQL server, which several spoolers use.
#pragma once

#include <chrono>

#include "host/queue/database.hpp"
#include "host/queue/postgres_connection.hpp"

namespace queue {

// One that has lost its connection connects again with the next call. One transaction at a time is
// on the server, of whichever spooler, as with SQLite.
class PostgresDatabase : public Database {
 public:
  // Connects, and makes the tables where they are missing. Throws Unavailable, std::runtime_error.
  explicit PostgresDatabase(const std::string& address);

  void execute(const std::string& sql) override;
  Result run(const std::string& sql, const std::vector<Value>& values) override;

  // How long a commit whose outcome is unknown is looked up, before OutcomeUnknown.
  static constexpr std::chrono::seconds patience{3};

 private:
  void begin() override;
  void commit() override;
  void roll_back() noexcept override;
  bool was_committed(const std::string& mark);

  PostgresConnection connection_;
  bool in_transaction_ = false;
  std::string session_;  // random
  std::int64_t commits_ = 0;
};

}  // namespace queue
