// SPDX-License-Identifier: Apache-2.0
// The firmware on the instant chip, in a state that is prepared once, and what must hold of it
// whatever lines come.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fuzz {

class ExecutorModel {
 public:
  // All of them share the firmware's memory: one at a time.
  explicit ExecutorModel(std::uint8_t state);

  // Sends a line. False where its answer does not come, soon if it is one that waits.
  bool exchange(std::string_view text, bool waits);
  // Ends what the last line waits for; false where it has no answer then.
  bool end_wait();
  bool halted() const;
  // Motion may still be under way, perhaps for longer than is worth to be waited for.
  bool moves() const;

  // The steps per millimetre or the limits are others from now on.
  void forget_travel() { travel_holds_ = false; }
  // The host's coordinates are not the machine's.
  void forget_origin() { origin_holds_ = false; }

  // Where the printer is at the end, and what it says of it.
  void check_place();
  // Where it has halted: for good.
  void check_halt();

 private:
  bool moves_long() const;
  void send(std::string_view text);
  void pass();
  bool await(unsigned oks, unsigned most_passes);
  void take_replies();
  void check_targets() const;
  void check_extremes() const;
  void check_reported_place(std::string_view report) const;

  unsigned oks_{};
  unsigned passes_{};  // since the last line was sent
  unsigned pass_of_line_{};  // the last that made one
  bool rejected_{};
  bool switched_off_{};  // heaters, by time
  bool travel_holds_;
  bool origin_holds_ = true;
  std::string place_;  // as M114 says it
};

}  // namespace fuzz
