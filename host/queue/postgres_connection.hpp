// SPDX-License-Identifier: Apache-2.0
// A connection to a PostgreSQL server on which a commit is on the disk when it returns.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <pqxx/pqxx>
#include <string>

#include "host/queue/call_limit.hpp"

namespace queue {

class PostgresConnection {
 public:
  // `address`: what libpq takes, as postgresql://USER@HOST/NAME or service=NAME; a password is in
  // ~/.pgpass or PGPASSFILE. Does not connect yet. Throws std::runtime_error where the address is
  // none or has a password, which every user of the machine could read.
  explicit PostgresConnection(const std::string& address);

  // Connects where there is no connection. Throws Unavailable, also at once where an attempt has
  // just failed; and std::runtime_error where the server is set not to write commits to its disk.
  void connect();
  bool is_open() const { return connection_ != nullptr; }

  // Does this on the connection, within some seconds. Throws Unavailable where there is none, where
  // it is lost or a lock is not to be had in time, std::runtime_error with the server's message.
  pqxx::result call(const std::function<pqxx::result(pqxx::nontransaction&)>& work);
  void execute(const std::string& sql);

  static constexpr std::chrono::milliseconds longest_call{8000};

 private:
  void check_settings();

  std::string address_;  // with limits of time where it has none
  CallLimit limit_{longest_call};
  std::unique_ptr<pqxx::connection> connection_;
  std::chrono::steady_clock::time_point failed_at_{};
  std::string failure_;  // of the last attempt to connect
};

}  // namespace queue
