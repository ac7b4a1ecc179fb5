// SPDX-License-Identifier: Apache-2.0
// The signal handler and its flag.
#include "tools/command/signals.hpp"

#include <csignal>

namespace command {

namespace {

volatile std::sig_atomic_t requested = 0;

void remember(int signal) {
  requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

bool interrupt_requested() { return requested != 0; }

}  // namespace command
