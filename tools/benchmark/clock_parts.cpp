// SPDX-License-Identifier: Apache-2.0
// Asks addr2line for the source of each address, and sorts sources into parts.
#include "tools/benchmark/clock_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "tools/process/process.hpp"

namespace benchmarks {

namespace {

struct Source {
  std::string_view place;  // below firmware/
  std::string_view part;
};

// The first that fits.
constexpr std::array sources{Source{"host_link/", "line"},
                             Source{"drivers/uart", "line"},
                             Source{"application/serial_exchange", "line"},
                             Source{"gcode/", "parse"},
                             Source{"motion/profile", "hand over"},
                             Source{"motion/", "plan"},
                             Source{"drivers/step_generator", "hand over"},
                             Source{"application/motion_task", "hand over"},
                             Source{"application/pace", "hand over"},
                             Source{"thermal/", "heat"},
                             Source{"application/heat", "heat"},
                             Source{"drivers/temperature", "heat"},
                             Source{"drivers/heater", "heat"},
                             Source{"application/application", "loop"},
                             Source{"application/tick_clock", "loop"},
                             Source{"drivers/", "loop"},
                             Source{"main.cpp", "loop"},
                             Source{"application/", "execute"},
                             Source{"platform/", "library"}};

// Of one frame; empty for headers that all use.
std::string_view part_of(std::string_view file) {
  constexpr std::string_view folder = "/firmware/";
  const std::size_t begin = file.rfind(folder);
  if (begin == std::string_view::npos) return {};
  const std::string_view place = file.substr(begin + folder.size());
  for (const Source& source : sources) {
    if (place.starts_with(source.place)) return source.part;
  }
  return {};
}

}  // namespace

std::map<std::string, double> clock_parts(const std::map<std::uint32_t, std::uint64_t>& samples,
                                          const std::filesystem::path& program) {
  std::vector<std::string> arguments{"riscv64-unknown-elf-addr2line", "-a", "-i", "-e",
                                     program.string()};
  double all = 0;
  for (const auto& [address, count] : samples) {
    arguments.push_back(fmt::format("{:#x}", address));
    all += static_cast<double>(count);
  }
  const auto answer = process::capture({.arguments = arguments});
  if (answer.exit_status != 0) throw std::runtime_error("addr2line: " + answer.output);
  std::map<std::string, double> parts;
  std::istringstream lines(answer.output);
  auto sample = samples.begin();
  std::string part;
  const auto count_sample = [&] {
    parts[part.empty() ? "library" : part] += static_cast<double>(sample->second) / all;
    ++sample;
  };
  bool first = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("0x")) {
      if (!first) count_sample();
      first = false;
      part.clear();
    } else if (part.empty() || part == "library") {
      if (const auto found = part_of(line); !found.empty()) part = found;
    }
  }
  if (!first) count_sample();
  return parts;
}

}  // namespace benchmarks
