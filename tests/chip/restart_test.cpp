// SPDX-License-Identifier: Apache-2.0
// M999 on the whole chip: the firmware restarts, with the heaters and the step generator as a
// fault has left them.
#include <gtest/gtest.h>

#include <string>

#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr sim::Clock second = clock_hz;

class Restart : public testing::Test, protected devices::ByteListener {
 protected:
  Restart() { loaded_.printer.serial_line().set_listener(*this); }
  void byte_received(sim::Clock, std::uint8_t byte) override { heard_ += static_cast<char>(byte); }
  // What the chip says until it has said `last`, and the line is forgotten then.
  void expect(const std::string& last) {
    const sim::Clock end = loaded_.simulation.now() + 10 * second;
    while (!heard_.contains(last + "\n") && loaded_.simulation.now() < end) run(0.005);
    ASSERT_TRUE(heard_.contains(last + "\n")) << "instead of " << last << ": " << heard_;
    heard_.erase(0, heard_.find(last + "\n") + last.size() + 1);
  }
  void say(const std::string& line) {
    loaded_.printer.serial_line().send(loaded_.simulation.now(), line + "\n");
  }
  void talk(const std::string& line, const std::string& answer = "ok") {
    say(line);
    expect(answer);
  }
  void run(double seconds) {
    loaded_.simulation.run_until(loaded_.simulation.now() +
                                 static_cast<sim::Clock>(seconds * second));
  }

  sim::VerilatedChip chip_{clock_hz};
  tests::LoadedPrinter loaded_{chip_, clock_hz, 190, 25};
  std::string heard_;
};

TEST_F(Restart, after_m112_moves_and_heats_again_when_asked) {
  expect("start");
  talk("G28 X");
  talk("G1 X10 F3000");
  talk("M104 S200");
  run(2);
  talk("G1 X60 F600");
  run(0.5);  // in the middle of the move
  talk("M112", "Error:Printer halted. kill() called!");
  const double hot = loaded_.printer.hotend_c();
  run(3);
  EXPECT_LT(loaded_.printer.hotend_c(), hot);
  talk("M999", "start");
  const double before = loaded_.printer.hotend_c();
  run(3);
  EXPECT_LT(loaded_.printer.hotend_c(), before) << "heats without having been asked";
  talk("M104 S210");
  run(8);
  const double coldest = loaded_.printer.hotend_c();
  run(6);
  EXPECT_GT(loaded_.printer.hotend_c(), coldest + 5);
  talk("G28 X");
  talk("G1 X5 F3000");
  talk("M400");
  talk("M114", "ok");
  run(0.1);
  EXPECT_EQ(chip_.queue_statistics().underruns, 0u);
}

}  // namespace
