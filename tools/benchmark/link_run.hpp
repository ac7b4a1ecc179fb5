// SPDX-License-Identifier: Apache-2.0
// One run of the whole chip with its firmware: lines of G-code in at the serial line, their replies
// and the step pulses out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/machine/description.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/simulation.hpp"

namespace benchmarks {

// Lines with number and checksum, as hosts send them.
class NumberedLines {
 public:
  // Begins a numbering.
  NumberedLines() { add("M110 N0"); }

  void add(const std::string& command) { lines_.push_back(framed(command)); }
  // `G1` to X and Y in a line of exactly `length` characters: with zeros after the decimals.
  void add_move(double x_mm, double y_mm, std::size_t length);

  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::string framed(const std::string& command) const;

  std::vector<std::string> lines_;
};

struct LinkOrder {
  std::vector<std::string> lines;
  std::size_t first_measured{};  // of the lines; those before it set up and fill the planner
  std::size_t window = 1;
  std::uint32_t clock_hz{};
  std::uint32_t baud{};
  double hotend_c = 25;  // at the start
  // So often the program counter is looked at while lines are measured; 0: never.
  sim::Clock sample_clocks{};
};

struct LinkRun {
  double lines_per_second{};
  // From the end of a line's last bit to the first bit of its `ok`; of one line in flight.
  double mean_latency_us{}, longest_latency_us{};
  double busy_percent{};  // of the processor's clocks, those in which it does not sleep
  double motion_seconds{};  // from the first step pulse to the last
  std::uint64_t underruns{};
  std::map<std::uint32_t, std::uint64_t> samples{};  // by program counter, awake
};

// Prints to the last answer. `look` is called many times a second; what it throws ends the run.
// Throws std::runtime_error where the chip speaks against a line or does not answer.
LinkRun run_link(const sim::ElfImage& firmware, const machine::Description& description,
                 const LinkOrder& order, const std::function<void()>& look);

}  // namespace benchmarks
