// SPDX-License-Identifier: Apache-2.0
// Firmware that is compiled for speed, on a chip with the memory for it, prints what the default
// firmware prints.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "directories.hpp"
#include "tests/scenarios/edge_rows.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"

namespace {

// A circle of short lines with corners between, a hop, and an arc.
std::string gcode() {
  std::string text = "M83\nG92 X0 Y0 Z0 E0\nG1 F6000\n";
  for (int i = 0; i < 240; ++i) {
    const int x = i % 16 < 8 ? i % 8 : 8 - i % 8, y = i / 4;
    text += fmt::format("G1 X{}.{} Y{}.{}\n", x / 4, x % 4 * 25, y / 8, y % 8 * 125);
  }
  return text + "G1 Z.5 F300\nG2 I5 J0 F3000\nM400\nM114\nM84\n";
}

struct Printed {
  scenarios::Position steps{};
  std::string counts;  // as M114 reports them
};

Printed print_with(unsigned memory_kib) {
  std::string machine = files::text_of(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  machine.insert(machine.find("kinematics = "), fmt::format("memory_kib = {}\n", memory_kib));
  const auto file = scenarios::scratch_folder() / fmt::format("memory_{}.toml", memory_kib);
  scenarios::write_file(file, machine);
  const auto print = scenarios::print_text(gcode(), {"--machine", file.string()});
  EXPECT_EQ(print.report["result"], "completed") << print.job.output;
  EXPECT_EQ(print.report["verdict"], "good") << print.job.output;
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  Printed printed;
  for (const scenarios::Instant& instant : scenarios::read_edges(print.edges.string()).instants) {
    for (std::size_t i = 0; i < scenarios::axes; ++i) printed.steps[i] += instant.step[i];
  }
  for (const auto& message : print.report["messages"]) {
    const auto text = message["text"].get<std::string>();
    if (const auto place = text.find("Count"); place != std::string::npos) {
      printed.counts = text.substr(place);
    }
  }
  return printed;
}

TEST(fast_firmware, makes_the_steps_of_the_default_firmware) {
  const Printed fast = print_with(192), small = print_with(104);
  EXPECT_EQ(fast.steps, small.steps);
  EXPECT_EQ(fast.counts, small.counts);
  EXPECT_FALSE(fast.counts.empty());
  EXPECT_NE(fast.steps, scenarios::Position{});
}

}  // namespace
