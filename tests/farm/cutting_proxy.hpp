// SPDX-License-Identifier: Apache-2.0
// Stands between spooler and PostgreSQL server, and cuts the connection in the middle of a COMMIT.
#pragma once

#include <atomic>
#include <filesystem>
#include <list>
#include <mutex>
#include <thread>

#include "tests/temporary_folder.hpp"

namespace farm_test {

enum class Cut {
  none,
  before_commit,  // the server never gets it
  after_commit,  // the server has done it, and its answer is lost
  late_commit,  // the client is cut off first; the server gets it a second later
  silence,  // nothing goes through any more, and nothing is closed
};

class CuttingProxy {
 public:
  explicit CuttingProxy(std::filesystem::path server_folder);
  ~CuttingProxy();
  CuttingProxy(const CuttingProxy&) = delete;
  CuttingProxy& operator=(const CuttingProxy&) = delete;

  const std::filesystem::path& socket_folder() const { return folder_.path(); }
  // At the next COMMIT, once.
  void cut(Cut how) { cut_ = how; }
  bool has_cut() const { return cut_ == Cut::none; }
  // New connections are closed at once.
  void refuse(bool refuses) { refuses_ = refuses; }

 private:
  void accept_clients();
  void pass_on(int client);

  TemporaryFolder folder_;
  std::filesystem::path server_folder_;
  int listener_ = -1;
  std::atomic<Cut> cut_ = Cut::none;
  std::atomic<bool> refuses_ = false, ends_ = false;
  std::list<std::thread> clients_;
  std::thread thread_;
};

}  // namespace farm_test
