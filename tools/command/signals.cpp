// SPDX-License-Identifier: Apache-2.0
// The signal handler and its flag.
#include "tools/command/signals.hpp"

#include <signal.h>

#include <array>
#include <csignal>
#include <ctime>

#include "tools/command/output.hpp"

namespace command {

namespace {

// One Ctrl-C can arrive twice: from the terminal and from a program that passes it on.
constexpr std::time_t echo_seconds = 1;

volatile std::sig_atomic_t requested = 0;
volatile std::time_t first_time = 0;

std::time_t seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

void remember(int signal) {
  if (requested == 0) {
    requested = 1;
    first_time = seconds_now();
  } else if (seconds_now() - first_time > echo_seconds) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

constexpr std::array caught{SIGINT, SIGTERM, SIGHUP};

void handle(void (*handler)(int), int flags) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  for (const int signal : caught) sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() { handle(remember, SA_RESTART); }

void end_at_interrupts() {
  end_if_interrupted();
  handle(SIG_DFL, 0);
}

WaitsEndAtInterrupts::WaitsEndAtInterrupts() {
  end_if_interrupted();
  handle(remember, 0);
}
WaitsEndAtInterrupts::~WaitsEndAtInterrupts() { handle(remember, SA_RESTART); }

void let_writes_fail() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupt_requested() { return requested != 0; }

void end_if_interrupted() {
  if (interrupt_requested()) throw Interrupted();
}

}  // namespace command
