// SPDX-License-Identifier: Apache-2.0
// Differences between a print and its file, line by line, as plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace report {

// A command of the file that the chip did not carry out.
struct RefusedLine {
  std::size_t file_line{};  // from 1
  std::string text;
  std::string reason;  // the chip's words
  // A command that should have moved or heated something makes the print bad; another is a warning.
  bool moves_or_heats{};
};

// An axis at the end of a line of the file. Positions count from the axis' end stop, or from where
// the axis stood at the beginning while it has not been homed.
struct AxisArrival {
  bool missed{};
  double wanted_mm{};  // as the file asks
  std::int64_t wanted_steps{};  // nearest to it, halves away from zero
  std::int64_t reached_steps{};
  double reached_mm{};
};

// A line of the file at the end of which an axis was not at its nearest step.
struct MissedPoint {
  std::size_t file_line{};
  std::string text;
  double seconds{};  // simulated
  std::array<AxisArrival, 5> axes{};  // x y z e, and e of a second extruder
};

struct Findings {
  std::vector<RefusedLine> refused;  // that should move or heat
  std::vector<RefusedLine> warnings;  // that move nothing: the print is not the worse for it
  std::vector<MissedPoint> missed;
  // All of them: the lists end at a bound.
  std::uint64_t refused_count{};
  std::uint64_t warning_count{};
  std::array<std::uint64_t, 5> missed_by_axis{};  // likewise
  std::array<bool, 5> homed_elsewhere{};  // G28 ended away from the end stop
  std::array<bool, 5> moved_after_end{};  // after the last line was made
  std::uint64_t lines_apart{};  // Z or E did not go along with X and Y
  double max_height_error_mm{};  // of Z from the mesh, between the ends of lines
  // Commands of the file that the chip never acknowledged; 0 where the user stopped the print.
  std::uint64_t lines_lost{};
  // Each is a sentence that makes the print bad. None: it is good.
  std::vector<std::string> problems;
};

}  // namespace report
