// SPDX-License-Identifier: Apache-2.0
// Servers and addresses with which an acknowledged job would not be safe are refused.
#include <gmock/gmock.h>

#include <pqxx/pqxx>
#include <thread>
#include <vector>

#include "host/queue/postgres_database.hpp"
#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"

namespace {

using farm_test::PostgresServer;
using queue::PostgresDatabase;
using testing::HasSubstr;

std::string refusal(const std::string& address) {
  try {
    PostgresDatabase database(address);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class ServerSettings : public testing::Test {
 protected:
  PostgresServer& server = farm_test::shared_server();
  std::string address = server.new_database();
  std::string name = address.substr(address.find("dbname=") + 7);
};

TEST_F(ServerSettings, commits_that_do_not_wait_for_the_disk_are_refused_with_the_remedy) {
  EXPECT_EQ(refusal(address), "");
  PostgresServer::execute(address, "ALTER DATABASE " + name + " SET synchronous_commit = off");
  EXPECT_THAT(refusal(address),
              testing::AllOf(HasSubstr("synchronous_commit off"), HasSubstr("could be lost")));
  PostgresServer::execute(address, "ALTER DATABASE " + name + " SET synchronous_commit = local");
  EXPECT_EQ(refusal(address), "");
}

TEST_F(ServerSettings, a_server_without_fsync_is_refused) {
  PostgresServer::execute(address, "ALTER SYSTEM SET fsync = off");
  PostgresServer::execute(address, "SELECT pg_reload_conf()");
  std::string why;
  for (int i = 0; i < 500 && why.empty(); ++i) {  // it reads its settings in its own time
    why = refusal(address);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_THAT(why, HasSubstr("fsync off"));
  PostgresServer::execute(address, "ALTER SYSTEM RESET fsync");
  PostgresServer::execute(address, "SELECT pg_reload_conf()");
  for (int i = 0; i < 500 && !why.empty(); ++i) {
    why = refusal(address);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(why, "");
}

TEST_F(ServerSettings, a_password_on_the_command_line_is_refused_and_not_repeated) {
  for (const char* with_one : {"postgresql://farm:geheim@localhost/farm", "password=geheim"}) {
    EXPECT_THAT(refusal(with_one), HasSubstr("PGPASSFILE"));
    EXPECT_THAT(refusal(with_one), testing::Not(HasSubstr("geheim")));
  }
  EXPECT_THAT(refusal("nonsense"), HasSubstr("--database"));
}

TEST_F(ServerSettings, tables_of_another_version_are_refused) {
  EXPECT_EQ(refusal(address), "");
  PostgresServer::execute(address, "UPDATE schema_version SET version = 99");
  EXPECT_THAT(refusal(address), HasSubstr("version 99"));
}

TEST_F(ServerSettings, a_database_with_another_encoding_is_refused) {
  PostgresServer::execute(address,
                          "CREATE DATABASE latin ENCODING 'LATIN1' LOCALE 'C' "
                          "TEMPLATE template0");
  EXPECT_THAT(refusal(PostgresServer::address(server.socket_folder(), "latin")), HasSubstr("UTF8"));
}

TEST_F(ServerSettings, spoolers_that_begin_together_make_the_tables_once) {
  std::vector<std::string> refusals(4);
  std::vector<std::thread> threads;
  for (std::string& each : refusals) threads.emplace_back([&] { each = refusal(address); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(refusals, testing::Each(""));
}

TEST_F(ServerSettings, a_server_that_is_away_is_said_to_be_so) {
  const TemporaryFolder empty;
  EXPECT_THROW(PostgresDatabase(PostgresServer::address(empty.path(), "none")), queue::Unavailable);
}

}  // namespace
