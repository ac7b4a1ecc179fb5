// SPDX-License-Identifier: Apache-2.0
// Plays a written dialogue between host, link and firmware, and reports where it differs.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>

#include "host_link/host_link.hpp"
#include "tests/dialogue_steps.hpp"

namespace host_link::test {

// One step of a dialogue a line; everything that happens must be written, and nothing else may
// happen:
//   ~> N5 G1\x00     the host sends these bytes, without a line end; \n \r \t \xhh
//   => 5 G1 X1       the firmware takes line 5 ("-" for a line without number)   => nothing
//   done T:20.00     the firmware has finished it, with this report after the ok
//   again                 it cannot read the line in hand, and that is requested again
//   not again             it cannot read it, and is to answer it
//   say text         the firmware sends a line
//   ?? 105           M105 is to be answered ahead of the lines that wait    ?? nothing
//   answer T:20.00   the firmware does, with this report after the ok
//   !! kill          an emergency command is signalled   (kill, cancel, stop, prompt 3,
//                    action pause, action resume, action cancel, speed 50)
//   idle 300         milliseconds pass; also: busy 300, paused 300
//   set advanced_ok | set busy_interval 500
//   repeat 20 -> M105        one step many times; "#" in it counts from 0
// and those of tests/dialogue_steps.hpp, with "<- nothing".
class Dialogue {
 public:
  // What went wrong and where, or nothing.
  std::optional<std::string> play(const std::filesystem::path& file);

 private:
  std::string step(const DialogueStep& next);
  std::string repeat(const DialogueStep& many);
  std::string expect_line(const std::string& expected);
  std::string expect_part(const std::string& expected);
  std::string expect_taken(const std::string& expected);
  std::string expect_query(const std::string& expected);
  std::string expect_emergency(const std::string& expected);
  std::string set(const std::string& argument);
  void send(const std::string& bytes);
  void pass(long milliseconds, Activity activity);
  void collect();
  std::string leftovers();

  HostLink link_;
  units::Milliseconds now_{1000};
  Activity activity_{Activity::idle};  // in the last pass
  std::string partial_;
  std::deque<std::string> lines_;
};

}  // namespace host_link::test
