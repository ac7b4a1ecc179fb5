// SPDX-License-Identifier: Apache-2.0
// PostgreSQL refuses to run as root: there it runs as the user of its Debian package.
#include "tests/farm/postgres_server.hpp"

#include <pwd.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <pqxx/pqxx>
#include <stdexcept>
#include <thread>

#include "tools/files/file_text.hpp"

namespace farm_test {

namespace fs = std::filesystem;

namespace {

const std::string programs = "/usr/lib/postgresql/17/bin/";
constexpr const char* user = "postgres";
constexpr std::chrono::seconds patience{60};  // on a machine under load

std::vector<std::string> as_its_user(std::vector<std::string> call) {
  if (geteuid() != 0) return call;
  // The signal at the end of its parent is lost with the change of the user.
  const std::vector<std::string> change{"setpriv",
                                        std::string("--reuid=") + user,
                                        std::string("--regid=") + user,
                                        "--clear-groups",
                                        "--pdeathsig",
                                        "INT"};
  call.insert(call.begin(), change.begin(), change.end());
  return call;
}

}  // namespace

PostgresServer::PostgresServer() {
  const fs::path data = folder_.path() / "data";
  fs::create_directory(data);
  if (geteuid() == 0) {
    const passwd* const entry = getpwnam(user);
    if (entry == nullptr) throw std::runtime_error("there is no user postgres");
    for (const fs::path& folder : {folder_.path(), data}) {
      if (chown(folder.c_str(), entry->pw_uid, entry->pw_gid) != 0) {
        throw std::runtime_error("cannot give away " + folder.string());
      }
    }
  }
  const auto made =
      process::capture({.arguments = as_its_user({programs + "initdb", "--pgdata", data.string(),
                                                  "--no-sync", "--auth=trust", "--username=farm",
                                                  "--encoding=UTF8", "--locale=C.UTF-8"}),
                        .folder = folder_.path(),
                        .has_input = false});
  if (made.exit_status != 0) throw std::runtime_error(made.output);
  start();
}

PostgresServer::~PostgresServer() {
  if (process_) stop(SIGQUIT);
}

void PostgresServer::start() {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    process_.emplace(process::Start{
        .arguments = as_its_user({programs + "postgres", "-D", (folder_.path() / "data").string(),
                                  "-k", folder_.path().string(), "-c", "listen_addresses=", "-c",
                                  "shared_buffers=16MB", "-c", "max_wal_senders=0"}),
        .folder = folder_.path(),
        .output = folder_.path() / "log",
        .has_input = false});
    try {
      ask_until_it_answers();
      return;
    } catch (const std::runtime_error&) {  // processes of the killed one may not have ended yet
      if (std::chrono::steady_clock::now() > end) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
}

void PostgresServer::ask_until_it_answers() {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    try {
      const pqxx::connection client(address(folder_.path(), "postgres"));
      return;
    } catch (const pqxx::broken_connection&) {
      const bool late = std::chrono::steady_clock::now() > end;
      if (late || process_->ending()) {
        throw std::runtime_error("PostgreSQL: " + files::text_of(folder_.path() / "log"));
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void PostgresServer::stop(int signal) {
  process_->signal(signal);
  process_->wait();
  process_.reset();
}

std::string PostgresServer::address(const fs::path& socket_folder, const std::string& name) {
  return "host=" + socket_folder.string() + " user=farm dbname=" + name;
}

void PostgresServer::execute(const std::string& address, const std::string& sql) {
  pqxx::connection client(address);
  pqxx::nontransaction(client).exec(sql);
}

std::string PostgresServer::new_database() {
  const std::string name = "test_" + std::to_string(++databases_);
  execute(address(folder_.path(), "postgres"), "CREATE DATABASE " + name);
  return address(folder_.path(), name);
}

PostgresServer& shared_server() {
  static PostgresServer server;
  return server;
}

}  // namespace farm_test
