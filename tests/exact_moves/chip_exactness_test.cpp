// SPDX-License-Identifier: Apache-2.0
// Random sequences of moves on the whole chip with its firmware: after each the step edges counted
// at the pins are those of exact arithmetic.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "sim/devices/file_host.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/exact_moves/random_lines.hpp"
#include "tests/loaded_printer.hpp"

namespace exact_moves {
namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr double largest_mm = 1.5;
constexpr double hotend_c = 205;

// Numbers of steps at the end of each sequence, which M400 is.
class EdgeCounter : public devices::StepListener, public devices::HostListener {
 public:
  void stepped(const devices::StepEdge& edge) override { counts_[edge.axis] += edge.direction; }
  void command_acknowledged(sim::Clock, std::size_t file_line, std::string_view command,
                            bool executed) override {
    if (!executed) refused.emplace_back(command);
    if (file_line != 0 && command == "M400") ends.push_back(counts_);
  }

  std::vector<std::array<std::int64_t, axis_count>> ends;
  std::vector<std::string> refused;

 private:
  std::array<std::int64_t, axis_count> counts_{};
};

struct Job {
  std::string gcode;
  std::vector<std::string> sequences;
  std::vector<std::array<std::int64_t, axis_count>> ends;
};

Job random_job(const machine::Description& description, std::size_t sequences) {
  std::array<std::int32_t, axis_count> steps_per_meter;
  for (std::size_t i = 0; i < axis_count; ++i) {
    steps_per_meter[i] =
        static_cast<std::int32_t>(std::lround(description.axes[i].steps_per_mm * 1000));
  }
  ExactAxes axes(steps_per_meter);
  RandomLines random(2026, largest_mm);
  std::mt19937_64 choice(7);
  Job job{.gcode = "M109 S205\nG1 F3000\n", .sequences = {}, .ends = {}};
  for (std::size_t i = 0; i < sequences; ++i) {
    std::string text;
    for (std::uint64_t left = 2 + choice() % 10; left > 0; --left) {
      const std::string line = random.next(axes);
      axes.take(line);
      text += line + "\n";
    }
    job.gcode += text + "M400\n";
    job.sequences.push_back(text);
    job.ends.push_back(axes.steps());
  }
  return job;
}

// CHIP_SEQUENCES chooses more.
TEST(chip_exactness, random_sequences_make_the_edges_of_exact_arithmetic) {
  const char* wanted = std::getenv("CHIP_SEQUENCES");
  const std::size_t sequences = wanted == nullptr ? 60 : std::strtoul(wanted, nullptr, 10);
  sim::VerilatedChip chip(clock_hz);
  tests::LoadedPrinter loaded(chip, clock_hz, hotend_c, 22);
  const Job job = random_job(loaded.description, sequences);
  EdgeCounter counter;
  loaded.printer.add_step_listener(counter);
  devices::FileHost host(devices::parse_gcode_text(job.gcode, "random").value(),
                         loaded.printer.serial_line(), loaded.simulation.rate());
  host.add_listener(counter);
  loaded.simulation.attach(host, {});
  while (!host.ended()) loaded.simulation.run_until(loaded.simulation.now() + clock_hz / 10);

  EXPECT_EQ(host.state(), devices::HostState::completed) << host.fault();
  EXPECT_EQ(counter.refused, std::vector<std::string>{});
  EXPECT_EQ(chip.queue_statistics().underruns, 0u);
  ASSERT_EQ(counter.ends.size(), job.ends.size());
  for (std::size_t i = 0; i < job.ends.size(); ++i) {
    ASSERT_EQ(counter.ends[i], job.ends[i]) << "sequence " << i << ":\n" << job.sequences[i];
  }
  std::printf("%zu sequences, %.0f s on the printer: no difference\n", job.ends.size(),
              loaded.simulation.seconds());
}

}  // namespace
}  // namespace exact_moves
