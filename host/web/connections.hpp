// SPDX-License-Identifier: Apache-2.0
// How long the server waits for clients that send or read nothing, and for how many at a time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>

namespace web {

struct WaitLimits {
  // For the head of a request. A body may take the same time, and more at `bytes_per_second`; but
  // no pause in what comes, or in what is taken of the answer, may be so long.
  std::chrono::milliseconds patience{10'000};
  double bytes_per_second = 2000;
  std::size_t longest_head = 32 * 1024;  // bytes
  // So many connections are waited for. Of more, the one that is due first is closed, of the client
  // that has most, so one with many pushes out its own ones.
  std::size_t most_waiting = 24;
};

using Clock = std::chrono::steady_clock;

// A connection whose request, or whose answer, is still on its way.
struct Awaited {
  int socket{};
  std::string client;  // its address
  Clock::time_point due;  // unchanged as long as it is entered
  std::atomic<bool> given_up = false;
};

// All those of a server; for any thread.
class Connections {
 public:
  explicit Connections(WaitLimits limits) : limits_(limits) {}

  const WaitLimits& limits() const { return limits_; }
  // Until leave(); gives another one up where there are too many.
  void enter(Awaited& connection);
  void leave(Awaited& connection);
  // All of them, and each that comes.
  void end();

 private:
  void give_up(Awaited& connection);

  WaitLimits limits_;
  std::mutex mutex_;
  std::set<Awaited*> awaited_;  // without those given up
  bool ends_ = false;
};

}  // namespace web
