// SPDX-License-Identifier: Apache-2.0
// The lines of the G-code that request motion, in order, to be drawn under the path as printed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/devices/host_listener.hpp"
#include "sim/report/gcode_path.hpp"
#include "sim/simulation/clock_rate.hpp"

namespace report {

struct RequestedMove {
  std::size_t file_line{};
  double seconds{};  // when the chip answered it; motion follows
  std::array<float, 3> from{}, to{};  // mm, in the coordinates of ToolPath
  bool extrudes{};
  bool executed{};  // false: refused
};

class RequestedPath : public devices::HostListener {
 public:
  explicit RequestedPath(sim::ClockRate rate, const MachineFacts& machine = {})
      : rate_(rate), gcode_(machine) {}

  // The lines are read when they are answered: what is refused changes nothing for those after.
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;
  // Forgets the lines before, which were not in the coordinates of the machine.
  void begin_here() { lines_.clear(); }

  const std::vector<RequestedMove>& lines() const { return lines_; }

 private:
  void add(const Move& move, RequestedMove line);

  sim::ClockRate rate_;
  GcodePath gcode_;
  std::vector<RequestedMove> lines_;
};

}  // namespace report
