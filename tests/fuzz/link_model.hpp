// SPDX-License-Identifier: Apache-2.0
// A host link as observed from outside: every line on the wire, every delivered line, every reply.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_link/host_link.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {

class LinkModel {
 public:
  // What happens.
  void put(char byte);
  void disturb() { lost_before_next_ = true; }  // the uart loses something
  void pause(int milliseconds);
  void work_on(host_link::Activity activity);
  void take_line();
  void finish_lines(unsigned count);
  void answer_query();
  void say(std::string_view line) { link_.say(line); }
  void hear(std::size_t most_bytes);

  // What a host does with it.
  void begin_numbered(std::uint32_t number);
  // With the XOR of the bytes so far, or another.
  void end_framed(unsigned error);
  std::uint32_t next_number() const { return last_sent_ + 1; }
  std::uint32_t requested_number() const { return asked_; }

  // What always holds.
  void check();
  // Whatever came before: after a pause a host's M110 and its lines are taken, once and in order.
  void require_that_a_new_host_is_served();

 private:
  // A line, or a part from a pause on, as it came.
  struct Raw {
    std::string bytes;
    bool disturbed;
  };

  void end_line();
  void deliver(const host_link::AcceptedLine& line);
  bool came_so(const host_link::AcceptedLine& line, const Raw& raw) const;
  bool may_follow(const host_link::AcceptedLine& line) const;
  void hear_line(std::string_view line);
  void put_text(std::string_view text);

  host_link::HostLink link_;
  std::int64_t now_ms_ = 0;
  host_link::Activity activity_ = host_link::Activity::idle;
  bool taken_ = false;

  std::vector<Raw> lines_;
  std::string line_;  // in progress
  std::vector<std::size_t> parts_{0};  // where in it a part may begin
  std::vector<std::size_t> disturbed_;  // in front of which of its bytes
  bool lost_before_next_ = false;  // byte
  bool after_return_ = false;
  std::vector<std::uint32_t> restarts_;  // numbers that an M110 may have made the next
  std::optional<std::uint32_t> last_delivered_;
  std::vector<std::string> texts_;  // delivered
  std::size_t delivered_ = 0;

  std::string heard_;
  std::size_t oks_ = 0, resends_ = 0, ends_ = 0;
  std::uint32_t last_sent_ = 0, asked_ = 0;
};

}  // namespace fuzz
