// SPDX-License-Identifier: Apache-2.0
// Ends a call over a socket that gets no answer, as when the network is cut: libpq itself would
// wait without end.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace queue {

class CallLimit {
 public:
  explicit CallLimit(std::chrono::milliseconds limit);
  ~CallLimit();
  CallLimit(const CallLimit&) = delete;
  CallLimit& operator=(const CallLimit&) = delete;

  // One call at a time. When the limit has passed the socket is shut down, and the call fails.
  class Call {
   public:
    Call(CallLimit& limit, int socket) : limit_(limit) { limit_.set(socket); }
    ~Call() { limit_.set(std::nullopt); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    CallLimit& limit_;
  };

 private:
  void set(std::optional<int> socket);
  void watch();

  const std::chrono::milliseconds limit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<int> socket_;  // of the call that runs
  std::chrono::steady_clock::time_point end_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace queue
