// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a wish that jobs look at, so that they can still write their report.
#pragma once

#include <stdexcept>

namespace command {

// From now on the first SIGINT, SIGTERM or SIGHUP only sets the wish; one that comes two seconds
// later ends the program at once.
void catch_interrupts();
bool interrupt_requested();

// Ends a job that has nothing to finish; main() gives its exit status.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};
void end_if_interrupted();

}  // namespace command
