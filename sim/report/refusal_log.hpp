// SPDX-License-Identifier: Apache-2.0
// Which lines of the file the chip refused, and why.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "sim/devices/host_listener.hpp"
#include "sim/report/findings.hpp"

namespace report {

// A prevented extrusion is a refusal too, although the rest of its line is executed.
class RefusalLog : public devices::HostListener {
 public:
  void command_sent(sim::Clock now, std::size_t file_line, std::string_view command) override;
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;
  void reply(sim::Clock now, std::string_view line) override;

  // Fills in the refused lines, the warnings and their counts.
  void report_to(Findings& findings) const;

 private:
  std::size_t in_flight_ = 0;
  std::string remark_;  // the last that the chip made on the line that it works on
  Findings findings_;
};

// The chip's message without its quotation of the line.
std::string reason_of(std::string_view remark);

}  // namespace report
