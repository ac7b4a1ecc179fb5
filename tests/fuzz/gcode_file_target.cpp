// SPDX-License-Identifier: Apache-2.0
// A G-code file as `print` reads and sends it, through the firmware's host link at the other end of
// the wire, on which one bit of some lines flips: every command arrives once and in order, or the
// file was refused.
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/devices/file_host.hpp"
#include "sim/devices/gcode_file.hpp"
#include "sim/report/gcode_path.hpp"
#include "tests/fuzz/property.hpp"
#include "tests/fuzz/wire.hpp"

namespace {

void require_clean(const std::vector<devices::FileCommand>& commands, std::string_view text) {
  std::size_t before = 0;
  for (const devices::FileCommand& command : commands) {
    fuzz::require(command.file_line > before, "lines are out of order");
    before = command.file_line;
    fuzz::require(
        !command.text.empty() && command.text.front() != ' ' && command.text.back() != ' ',
        "\"{}\" has blanks around it", command.text);
    fuzz::require(std::ranges::all_of(command.text, [](char c) { return c >= ' ' && c <= '~'; }),
                  "line {} goes out with a byte that is no ASCII", command.file_line);
  }
  fuzz::require(before <= static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1,
                "a command has line {} of fewer", before);
}

// The judge of prints takes every command that is sent.
void judge(const std::vector<devices::FileCommand>& commands) {
  report::GcodePath path;
  for (const devices::FileCommand& command : commands) path.read(command.text);
}

// Longer ones find nothing more and are slow.
constexpr std::size_t most_bytes = 1500;

}  // namespace

// Up to the first NUL the file, then which bit of which byte of each line flips: 0 none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  size = std::min(size, most_bytes);
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  const auto commands = devices::parse_gcode_text(input.substr(0, end), "file.gcode");
  if (!commands) {
    fuzz::require(commands.error().contains("file.gcode"), "a refusal names no file: {}",
                  commands.error());
    return 0;
  }
  require_clean(*commands, input.substr(0, end));
  judge(*commands);
  fuzz::print_over_wire(*commands, std::span(data, size).subspan(std::min(end + 1, size)));
  return 0;
}
