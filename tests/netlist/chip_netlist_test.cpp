// SPDX-License-Identifier: Apache-2.0
// A board's netlist boots its firmware out of its block RAM, answers, heats and moves, pin for pin
// and clock for clock as the model of the chip that was never synthesised.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/loaded_printer.hpp"
#include "tests/netlist/netlist_twin.hpp"

namespace {

using testing::HasSubstr;
using testing::Not;

// The netlists were made for this clock.
constexpr std::uint32_t clock_hz = 50'000'000;
constexpr sim::Clock millisecond = clock_hz / 1000;

// Sends the next line when the last one is acknowledged, and stops the simulation when all are.
class Dialogue : public sim::Device, public devices::ByteListener {
 public:
  Dialogue(sim::Simulation& simulation, devices::SerialLine& line, std::vector<std::string> lines)
      : simulation_(simulation), line_(line), lines_(std::move(lines)) {}

  void byte_received(sim::Clock now, std::uint8_t byte) override {
    heard += static_cast<char>(byte);
    if (byte != '\n') return;
    const std::string_view reply = std::string_view(heard).substr(line_start_);
    if (reply.starts_with("start") || reply.starts_with("ok")) {
      if (next_ == lines_.size()) {
        completed = true;
        simulation_.stop();
      } else {
        line_.send(now, lines_[next_++] + "\n");
      }
    }
    line_start_ = heard.size();
  }

  std::string heard;
  bool completed = false;

 private:
  sim::Simulation& simulation_;
  devices::SerialLine& line_;
  std::vector<std::string> lines_;
  std::size_t next_ = 0, line_start_ = 0;
};

class StepCounter : public devices::StepListener {
 public:
  void stepped(const devices::StepEdge& edge) override { ++steps.at(edge.axis); }
  std::array<std::size_t, sim::axis_count> steps{};
};

TEST(ChipNetlist, boots_answers_heats_and_moves_as_the_model_does_in_every_clock) {
#ifdef CONTENTS_DIRECTORY
  // Quartus' files of the memory's contents are here; the model of the block RAM reads them.
  std::filesystem::current_path(CONTENTS_DIRECTORY);
#endif
  tests::NetlistTwin chip(clock_hz);
  // Warm sensors are soon measured. M105 would wait for the first reading: too long here.
  tests::LoadedPrinter loaded(chip, clock_hz, 150.0, 100.0);
  StepCounter counter;
  loaded.printer.add_step_listener(counter);
  Dialogue dialogue(
      loaded.simulation, loaded.printer.serial_line(),
      {"M115", "M106 S100", "M104 S180", "G91", "G1 X0.4 Y-0.2 F6000", "M400", "M114"});
  loaded.printer.serial_line().set_listener(dialogue);

  ASSERT_NO_THROW(loaded.simulation.run_until(200 * millisecond)) << dialogue.heard;
  EXPECT_TRUE(dialogue.completed) << dialogue.heard;
  EXPECT_THAT(dialogue.heard, HasSubstr("FIRMWARE_NAME:StepFabric"));
  EXPECT_THAT(dialogue.heard, Not(HasSubstr("Error")));
  EXPECT_GT(chip.now(), 1'000'000u);
  EXPECT_THAT(dialogue.heard, HasSubstr("Count X:32 Y:-16"));
  EXPECT_EQ(counter.steps[0], 32u);
  EXPECT_EQ(counter.steps[1], 16u);
  // The processor did rest, and in the same clocks.
  EXPECT_GT(chip.processor_statistics().sleeping_clocks, 0u);
  EXPECT_EQ(chip.netlist_sleeping_clocks(), chip.processor_statistics().sleeping_clocks);
}

}  // namespace
