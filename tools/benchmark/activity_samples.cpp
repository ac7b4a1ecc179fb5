// SPDX-License-Identifier: Apache-2.0
// A timer on the thread's processor time, and the handler of its signal.
#include "tools/benchmark/activity_samples.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace benchmarks {

namespace {

// The kernel looks at such timers at its ticks: mostly 4 ms.
constexpr long step_ns = 1'000'000;

std::array<std::atomic<std::uint64_t>, sim::activity_count> samples;
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

void take_sample(int) {
  const auto activity = sim::current_activity.load(std::memory_order_relaxed);
  samples[static_cast<std::size_t>(activity)].fetch_add(1, std::memory_order_relaxed);
}

void check(int result, const char* what) {
  if (result != 0) throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

ActivitySamples::ActivitySamples() {
  for (auto& count : samples) count = 0;
  // Left in place: a signal may be on its way when the timer is removed.
  struct sigaction action{};
  action.sa_handler = take_sample;
  action.sa_flags = SA_RESTART;
  check(sigaction(SIGPROF, &action, nullptr), "sigaction");
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = SIGPROF;
  event._sigev_un._tid = gettid();
  check(timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &timer_), "timer_create");
  const itimerspec steps{.it_interval = {.tv_sec = 0, .tv_nsec = step_ns},
                         .it_value = {.tv_sec = 0, .tv_nsec = step_ns}};
  check(timer_settime(timer_, 0, &steps, nullptr), "timer_settime");
}

ActivitySamples::~ActivitySamples() { timer_delete(timer_); }

ActivityCounts ActivitySamples::counts() const {
  ActivityCounts counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = samples[i];
  return counts;
}

}  // namespace benchmarks
