// SPDX-License-Identifier: Apache-2.0
// Follows the spooler and reports to the sinks what happens.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "host/notify/event_finder.hpp"
#include "host/notify/sink.hpp"
#include "host/spooler/spooler.hpp"

namespace notify {

// In a thread of its own until its end. What is there when it is made is no news, so it is made
// before the spooler runs.
class Notifier {
 public:
  Notifier(spooler::Spooler& spooler, std::vector<std::unique_ptr<Sink>> sinks,
           EventFinder finder = EventFinder());
  ~Notifier();
  Notifier(const Notifier&) = delete;
  Notifier& operator=(const Notifier&) = delete;

 private:
  void run();
  void look();

  spooler::Spooler& spooler_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  EventFinder finder_;
  std::string run_;  // at random: numbers of events of another run are others
  std::int64_t number_ = 0;
  std::int64_t version_ = 0;  // of the snapshot that was shown

  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace notify
