// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a request that jobs poll, so that they can still write their report.
#pragma once

#include <stdexcept>

namespace command {

// From now on the first SIGINT, SIGTERM or SIGHUP only sets the request; one that comes two seconds
// later ends the program at once.
void catch_interrupts();
bool interrupt_requested();
// Again the first one ends the program at once: for a job that has nothing to finish.
void end_at_interrupts();
// While it exists, a signal also interrupts a blocking call, such as opening a pipe that has
// no reader.
class WaitsEndAtInterrupts {
 public:
  WaitsEndAtInterrupts();
  ~WaitsEndAtInterrupts();
  WaitsEndAtInterrupts(const WaitsEndAtInterrupts&) = delete;
  WaitsEndAtInterrupts& operator=(const WaitsEndAtInterrupts&) = delete;
};

// Ends a job that has nothing to finish; main() gives its exit status.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};
void end_if_interrupted();

// The result of `open`, which may block until the other end of a pipe is opened.
template <class Open>
auto opened(const Open& open) {
  const WaitsEndAtInterrupts ending;
  try {
    return open();
  } catch (const std::runtime_error&) {
    end_if_interrupted();
    throw;
  }
}

}  // namespace command
