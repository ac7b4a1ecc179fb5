// SPDX-License-Identifier: Apache-2.0
// A LinkPrinter at a pseudo-terminal, in real time.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/host/link_printer.hpp"

namespace host_test {

class PtyPrinter {
 public:
  // `path`: symlink to the port.
  explicit PtyPrinter(std::filesystem::path path);
  ~PtyPrinter();
  PtyPrinter(const PtyPrinter&) = delete;
  PtyPrinter& operator=(const PtyPrinter&) = delete;

  // The cable; a new one has another terminal at the same path.
  void unplug();
  void plug_in();
  // The next byte from the host is changed.
  void damage_next_byte() { damage_ = true; }
  // The printer, while it does not work.
  void with(const std::function<void(LinkPrinter&)>& action);
  std::vector<std::string> executed();

 private:
  void run();

  std::filesystem::path path_;
  std::mutex mutex_;
  LinkPrinter printer_;
  int master_ = -1, slave_ = -1;
  std::atomic<bool> damage_ = false, ends_ = false;
  std::thread thread_;
};

}  // namespace host_test
