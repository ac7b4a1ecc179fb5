// SPDX-License-Identifier: Apache-2.0
// Parses, and looks at every number as the command's executor does.
#include "benchmark/parser_work.hpp"

#include "benchmark/text_lines.hpp"
#include "gcode/parser.hpp"
#include "units/axes.hpp"

namespace benchmark {

ProcessorResult ParserWork::run(std::uint32_t iterations) {
  ProcessorResult result;
  gcode::Command command;
  for (std::uint32_t i = 0; i < iterations; ++i) {
    TextLines lines(text_);
    while (const auto line = lines.next()) {
      ++result.units;
      if (gcode::parse(*line, command)) continue;
      for (const char letter : units::axis_letters) {
        const auto value = command.value(letter);
        if (value) result.checksum = 31 * result.checksum + static_cast<std::uint32_t>(*value);
      }
    }
  }
  return result;
}

}  // namespace benchmark
