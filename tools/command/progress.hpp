// SPDX-License-Identifier: Apache-2.0
// The line that shows how far a print is: rewritten on a terminal, now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace command {

struct ProgressFacts {
  std::size_t done{};
  std::size_t total{};
  double simulated_seconds{};
  std::uint64_t clocks{};
  double x_mm{}, y_mm{}, z_mm{};
  double hotend_c{}, bed_c{};
};

class Progress {
 public:
  Progress();

  // Whether enough time has passed to show something new.
  bool due() const;
  void show(const ProgressFacts& facts);
  void show_text(const std::string& line);
  // Ends the line that is rewritten.
  void finish();

 private:
  using Time = std::chrono::steady_clock;

  bool terminal_;
  std::chrono::duration<double> interval_;
  Time::time_point shown_at_;
  std::uint64_t shown_clocks_ = 0;
  bool line_open_ = false;
};

}  // namespace command
