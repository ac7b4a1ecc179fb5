// SPDX-License-Identifier: Apache-2.0
// The checks of a command's arguments before its handler is called: part of its row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gcode/command.hpp"
#include "host_link/text_line.hpp"

namespace application {

// How an argument out of its range, or without a number, is handled.
enum class Check : std::uint8_t {
  none,  // the handler looks after it
  number,  // without a number the line is refused
  clamped,  // the nearest in the range counts
  refused,  // the line is refused
  tool,  // as `refused`, in Marlin's words for a tool that is not there
};

struct ArgumentLimit {
  char letter{};
  Check check{};
  bool required{};
  std::int8_t least{};
  std::int32_t most{};

  bool operator==(const ArgumentLimit&) const = default;
};

using ArgumentLimits = std::span<const ArgumentLimit>;
inline constexpr std::size_t most_limits = 9;  // of a row

// The first that the command does not keep; null where it keeps all.
const ArgumentLimit* violated(const gcode::Command& command, ArgumentLimits limits);

// Why that refuses the command, behind "echo:": with Check::tool all that is said of
// the line.
host_link::TextLine describe(const gcode::Command& command, const ArgumentLimit& limit);

// `value` cut to the range of the letter, in `units_per_one` of a whole.
std::int64_t clamped(ArgumentLimits limits, char letter, std::int64_t value,
                     std::int64_t units_per_one);

}  // namespace application
