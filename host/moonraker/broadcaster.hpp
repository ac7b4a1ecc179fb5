// SPDX-License-Identifier: Apache-2.0
// Follows the spooler and notifies all connections of what has changed.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "host/moonraker/core.hpp"
#include "host/moonraker/machine.hpp"

namespace moonraker {

// Works in a thread of its own until its end.
class Broadcaster {
 public:
  explicit Broadcaster(Core& core);
  ~Broadcaster();
  Broadcaster(const Broadcaster&) = delete;
  Broadcaster& operator=(const Broadcaster&) = delete;

 private:
  void run();
  void try_pass();
  void pass();
  void tell_klippy_state(const PrinterView& view);
  void tell_console(const PrinterView& view);
  void tell_jobs();
  void tell_files();
  void tell_queue();
  void tell_history();
  void tell(std::string_view method, const Json& params = nullptr);

  Core& core_;
  bool is_first_ = true;  // nothing is news yet
  std::int64_t version_ = 0;
  std::string klippy_state_;
  std::int64_t said_ = 0;  // console lines that were sent
  struct File {
    std::string stored;  // its name in the store
    std::int64_t bytes{}, uploaded_ms{};
  };
  std::map<std::string, File> files_;
  std::vector<std::string> queued_;
  std::string queue_state_;
  std::map<queue::JobId, bool> begun_;  // whether it is over
  double sampled_at_ = 0;
  ProcessorTime used_;

  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace moonraker
