// SPDX-License-Identifier: Apache-2.0
// Where notifications go.
#pragma once

#include <functional>
#include <string>

#include "host/notify/event.hpp"

namespace notify {

// What is wrong with a receiver, for the log of the spooler; from any thread.
using Log = std::function<void(const std::string& line)>;

// Both calls return at once, whatever the receiver does: they note what is to be sent, and a thread
// of the sink sends it.
class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;

  virtual void take(const Event& event) = 0;
  // The spooler's snapshot, when it has changed; for sinks that show what is now.
  virtual void show(const Json& snapshot) = 0;
};

}  // namespace notify
