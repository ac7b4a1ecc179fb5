// SPDX-License-Identifier: Apache-2.0
// Gated clock edges change nothing: the whole chip prints with and without them.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <string_view>

#include "tests/chip/resting_twins.hpp"
#include "tests/loaded_printer.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr sim::Clock millisecond = clock_hz / 1000;

// Sends a line now and then, whether it is requested or not, and disturbs the pins that the
// printer's other devices leave alone: bouncing switches, a noisy serial line, the emergency stop.
class RandomInputs : public sim::Device, public devices::ByteListener {
 public:
  RandomInputs(devices::SerialLine& line, sim::InputPins& inputs) : line_(line), inputs_(inputs) {
    next_wake_ = 1;
  }

  void wake(sim::Clock now) override {
    if (now >= next_line_ && lines_sent_ < lines.size()) {
      line_.send(now, lines[lines_sent_++]);
      next_line_ = now + 20 * millisecond;
    }
    // Of the axes' own switches none is among these.
    inputs_.end_stops = static_cast<std::uint8_t>((inputs_.end_stops & 0x0f) | (random_() & 0xf0));
    if (random_() % 16 == 0) {
      inputs_.emergency_stop = now > emergency_from && !inputs_.emergency_stop;
    }
    if (now > noise_from && line_.waiting_bytes() == 0) inputs_.receive = random_() % 4 != 0;
    // From every clock to rarely: the filters see bounces, levels and long rests.
    next_wake_ = now + 1 + random_() % (std::uint64_t{1} << random_() % 18);
  }

  void byte_received(sim::Clock, std::uint8_t) override { ++bytes_heard; }

  std::size_t bytes_heard = 0;

  static constexpr sim::Clock emergency_from = 750 * millisecond, noise_from = 900 * millisecond;

 private:
  static constexpr std::array<std::string_view, 14> lines{"M110 N0\n",        "M105\n",
                                                          "M302 S0\n",        "M104 S60\n",
                                                          "M140 S40\n",       "M106 S100\n",
                                                          "G28 X\n",          "M114\n",
                                                          "G1 X3 Y4 F3000\n", "G1 X0.5 Y1 Z0.1\n",
                                                          "G1 X4 Y4 F6000\n", "G1 X2 E1 F600\n",
                                                          "G4 P20\n",         "M105\n"};

  devices::SerialLine& line_;
  sim::InputPins& inputs_;
  std::mt19937_64 random_{7};
  std::size_t lines_sent_ = 0;
  sim::Clock next_line_ = 60 * millisecond;
};

class StepCounter : public devices::StepListener {
 public:
  void stepped(const devices::StepEdge&) override { ++steps; }
  std::size_t steps = 0;
};

TEST(rest, the_whole_chip_does_the_same_with_all_clock_edges_and_with_those_that_matter) {
  tests::RestingTwins chip(clock_hz);
  tests::LoadedPrinter loaded(chip, clock_hz, 40.0, 30.0);
  StepCounter counter;
  loaded.printer.add_step_listener(counter);
  RandomInputs random_inputs(loaded.printer.serial_line(), chip.inputs());
  loaded.printer.serial_line().set_listener(random_inputs);
  loaded.simulation.attach(random_inputs, {});

  ASSERT_NO_THROW(loaded.simulation.run_until(RandomInputs::noise_from));
  ASSERT_NO_THROW(chip.compare_inside());
  // There was activity, and the processor did sleep.
  EXPECT_GT(counter.steps, 500u);
  EXPECT_GT(random_inputs.bytes_heard, 100u);
  EXPECT_GT(chip.processor_statistics().sleeping_clocks, chip.now() / 4);

  ASSERT_NO_THROW(loaded.simulation.run_until(RandomInputs::noise_from + 100 * millisecond));
  ASSERT_NO_THROW(chip.reset());
  ASSERT_NO_THROW(loaded.simulation.run_until(RandomInputs::noise_from + 200 * millisecond));
  ASSERT_NO_THROW(chip.compare_inside());
}

}  // namespace
