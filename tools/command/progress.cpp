// SPDX-License-Identifier: Apache-2.0
// Writing of the progress line to standard error.
#include "tools/command/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "tools/command/output.hpp"

namespace command {

namespace {
constexpr std::chrono::duration<double> terminal_interval{0.5};
constexpr std::chrono::duration<double> log_interval{15.0};
}  // namespace

Progress::Progress()
    : terminal_(isatty(STDERR_FILENO) != 0),
      interval_(terminal_ ? terminal_interval : log_interval),
      shown_at_(Time::now()) {}

bool Progress::due() const { return Time::now() - shown_at_ >= interval_; }

void Progress::show(const ProgressFacts& facts) {
  const Time::time_point now = Time::now();
  const double seconds = std::chrono::duration<double>(now - shown_at_).count();
  const double clocks_per_second =
      static_cast<double>(facts.clocks - shown_clocks_) / std::max(seconds, 1e-9);
  const double percent =
      facts.total == 0 ? 0.0
                       : 100.0 * static_cast<double>(facts.done) / static_cast<double>(facts.total);
  const std::string line = fmt::format(
      "{:5.1f} %  {:7.1f} s  X{:7.2f} Y{:7.2f} Z{:6.2f}  hotend {:5.1f} °C  bed {:5.1f} °C  "
      "{:5.2f} M clocks/s",
      percent, facts.simulated_seconds, facts.x_mm, facts.y_mm, facts.z_mm, facts.hotend_c,
      facts.bed_c, clocks_per_second * 1e-6);
  show_text(line);
  shown_clocks_ = facts.clocks;
}

void Progress::show_text(const std::string& line) {
  if (terminal_) {
    say_to(stderr, "\r{}\x1b[K", line);
    line_open_ = true;
  } else {
    say_to(stderr, "{}\n", line);
  }
  std::fflush(stderr);
  shown_at_ = Time::now();
}

void Progress::finish() {
  if (line_open_) {
    say_to(stderr, "\n");
    line_open_ = false;
  }
}

}  // namespace command
