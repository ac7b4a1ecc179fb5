// SPDX-License-Identifier: Apache-2.0
// A host program that is observed only through the lines that the firmware accepts and answers.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "sim/devices/host_listener.hpp"
#include "sim/report/firmware_watch.hpp"

namespace report {

// Turns accepted and finished lines into the commands that the recorder listens to: one
// after the other, each counted as sent when the one before it is done. `file_line` counts
// the accepted lines.
class ServedHost : public devices::Host {
 public:
  void accepted(sim::Clock now, const AcceptedLine& line);
  void finished(sim::Clock now, bool executed);
  // It comes again.
  void withdrawn(sim::Clock now);
  // Bytes from the chip, whole lines or not.
  void heard(sim::Clock now, char byte);
  void set_resends(std::uint64_t count) { counts_.resends = count; }
  // The chip has been reset: what it had not done it has forgotten.
  void start_over() { waiting_.clear(); }

 private:
  struct Command {
    std::size_t number;
    std::string text;
  };

  void announce(sim::Clock now);

  std::deque<Command> waiting_;  // the first is with the firmware
  std::string reply_;
};

}  // namespace report
