// SPDX-License-Identifier: Apache-2.0
// A printer for a feeder: the firmware's own host link, and commands that take no time.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host_link/host_link.hpp"

namespace host_test {

class LinkPrinter {
 public:
  LinkPrinter() { restart(); }

  // As M155 asks, it reports temperatures by itself. After a reset it greets, and knows nothing
  // of what was before.
  void restart();
  void receive(std::string_view bytes, std::chrono::milliseconds now);
  // Works, and returns what it sends.
  std::string work(std::chrono::milliseconds now);

  // The next reply line is lost.
  void lose_next_ok() { lose_ok_ = true; }
  // It says so, and answers nothing until it is restarted.
  void halt(std::string_view message);
  // It says so, and goes on.
  void say(std::string_view message) { unsent_ += std::string(message) + "\n"; }
  bool waits() const { return waiting_; }
  // M104 and M109 set it. M109 takes `heating_time`, and says so every second; where M108 ends it
  // before, the hotend is not hot.
  double hotend_target() const { return hotend_target_; }
  bool heats() const { return heated_at_.has_value(); }
  static constexpr std::chrono::milliseconds heating_time{20'000};

  // Texts with a number but for those of the feeder itself, in the order of their execution.
  std::vector<std::string> executed;
  // Those without a number.
  std::vector<std::string> typed;
  // Whether the moves had been waited for when it said an M118's text.
  bool said_at_rest = false;

 private:
  std::string temperatures() const;
  void report(std::chrono::milliseconds now);
  bool execute(const host_link::AcceptedLine& line, std::chrono::milliseconds now);
  bool is_heated(const std::string& text, std::chrono::milliseconds now);
  void obey(const host_link::EmergencyCommand& command);

  std::optional<host_link::HostLink> link_;
  std::optional<host_link::AcceptedLine> in_hand_;  // the one that waits
  std::string unsent_;
  bool lose_ok_ = false, halted_ = false, waiting_ = false, wait_is_over_ = false, at_rest_ = false;
  std::chrono::milliseconds report_interval_{0}, reported_at_{0};  // 0: by request only
  double hotend_target_ = 0;
  bool is_hot_ = true;
  std::optional<std::chrono::milliseconds> heated_at_;  // when the M109 in hand ends
  std::size_t skipped_ = 0;  // lines that wait and are not executed
};

}  // namespace host_test
