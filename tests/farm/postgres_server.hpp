// SPDX-License-Identifier: Apache-2.0
// A PostgreSQL server of its own for a test, on a socket in a temporary folder.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace farm_test {

class PostgresServer {
 public:
  // Started. Throws std::runtime_error with what the server says.
  PostgresServer();
  ~PostgresServer();

  void start();
  // SIGQUIT, as `pg_ctl stop -m immediate`, or SIGKILL: it saves nothing more.
  void stop(int signal);

  // Of a new and empty database.
  std::string new_database();
  // Of a database at this socket, as where a proxy has its own.
  static std::string address(const std::filesystem::path& socket_folder, const std::string& name);
  const std::filesystem::path& socket_folder() const { return folder_.path(); }
  // On the database of this address, by a client of its own.
  static void execute(const std::string& address, const std::string& sql);

 private:
  void ask_until_it_answers();

  TemporaryFolder folder_;
  std::optional<process::Process> process_;
  int databases_ = 0;
};

// One for all tests of a program, made when it is first needed.
PostgresServer& shared_server();

}  // namespace farm_test
