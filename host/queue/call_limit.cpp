// SPDX-License-Identifier: Apache-2.0
// A thread that waits for the end of the call.
#include "host/queue/call_limit.hpp"

#include <sys/socket.h>

namespace queue {

CallLimit::CallLimit(std::chrono::milliseconds limit)
    : limit_(limit), thread_([this] { watch(); }) {}

CallLimit::~CallLimit() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void CallLimit::set(std::optional<int> socket) {
  const std::scoped_lock lock(mutex_);
  // The thread looks at the time when its wait is over: waking it for each call costs more.
  end_ = std::chrono::steady_clock::now() + limit_;
  socket_ = socket;
}

void CallLimit::watch() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    const auto now = std::chrono::steady_clock::now();
    if (socket_ && now >= end_) {
      shutdown(*socket_, SHUT_RDWR);
      socket_.reset();
    }
    changed_.wait_until(lock, socket_ ? end_ : now + limit_ / 8);
  }
}

}  // namespace queue
