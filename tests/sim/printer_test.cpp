// SPDX-License-Identifier: Apache-2.0
// The whole world around the chip, with a fake chip that makes the pulses a test requests.
#include "sim/machine/printer.hpp"

#include <gmock/gmock.h>

#include "sim/devices/file_host.hpp"
#include "sim/machine/surroundings.hpp"
#include "sim/report/recorder.hpp"
#include "tests/default_machine.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

constexpr sim::ClockRate rate(4'000'000);

class PrinterTest : public testing::Test {
 protected:
  void make(machine::PrinterOptions options = {}) {
    options.baud = 250'000;
    options.hotend_start_c = options.bed_start_c = machine::ambient_celsius;
    printer.emplace(tests::default_machine(), options, simulation);
  }
  // Plans slow steps of an axis from now on; returns the clock after them.
  sim::Clock steps(sim::Clock from, std::size_t axis, std::int64_t count) {
    for (std::int64_t i = 0; i < std::abs(count); ++i) {
      from += 4000;
      chip.plan_step(from, axis, count < 0);
    }
    return from + 100;
  }
  void enable_motors() {
    for (unsigned axis = 0; axis < 4; ++axis) {
      chip.plan(chip.now() + 1, sim::OutputPins::enable_bit + axis, true);
    }
  }

  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
  std::optional<machine::Printer> printer;
  sim::Clock homed_at = 0;
};

TEST_F(PrinterTest, stands_at_a_position_that_the_seed_decides) {
  machine::PrinterOptions options;
  options.seed = 1;
  make(options);
  const std::int64_t first = printer->axis(0).position();
  EXPECT_GT(first, 0);
  EXPECT_LT(first, 200 * 80);
  tests::FakeChip other_chip;
  sim::Simulation other_simulation(other_chip, rate);
  options.baud = 250'000;
  machine::Printer same(tests::default_machine(), options, other_simulation);
  EXPECT_EQ(same.axis(0).position(), first);
  options.seed = 2;
  machine::Printer other(tests::default_machine(), options, other_simulation);
  EXPECT_NE(other.axis(0).position(), first);
}

TEST_F(PrinterTest, closes_the_end_stop_exactly_where_position_0_is) {
  make();
  enable_motors();
  const std::int64_t start = printer->axis(1).position();
  sim::Clock end = steps(0, 1, -(start - 1));
  simulation.run_until(end);
  EXPECT_EQ(chip.inputs().end_stops, 0);
  end = steps(end, 1, -1);
  simulation.run_until(end);
  EXPECT_EQ(printer->axis(1).position(), 0);
  EXPECT_EQ(chip.inputs().end_stops, 1U << 1);
  end = steps(end, 1, 1);
  simulation.run_until(end);
  EXPECT_EQ(chip.inputs().end_stops, 0);
}

TEST_F(PrinterTest, never_closes_an_end_stop_that_is_broken) {
  machine::PrinterOptions options;
  machine::add_fault(options.faults, "x-end-stop-never-closes");
  make(options);
  enable_motors();
  simulation.run_until(steps(0, 0, -printer->axis(0).position() - 10));
  EXPECT_EQ(printer->axis(0).position(), -10);
  EXPECT_EQ(chip.inputs().end_stops, 0);
}

TEST_F(PrinterTest, heats_the_block_whose_gate_is_open) {
  make();
  chip.plan(1, sim::OutputPins::heater_supply_bit, true);
  chip.plan(1, sim::OutputPins::heater_bit, true);
  simulation.run_until(rate.clocks(30));
  EXPECT_GT(printer->hotend_c(), 60);
  EXPECT_NEAR(printer->bed_c(), machine::ambient_celsius, 0.1);
}

TEST_F(PrinterTest, heats_on_with_a_gate_that_is_stuck) {
  machine::PrinterOptions options;
  machine::add_fault(options.faults, "bed-heater-stuck-on@5");
  make(options);
  simulation.run_until(rate.clocks(5));
  EXPECT_NEAR(printer->bed_c(), machine::ambient_celsius, 0.1);
  chip.plan(rate.clocks(5) + 1, sim::OutputPins::heater_supply_bit, true);
  simulation.run_until(rate.clocks(60));
  EXPECT_GT(printer->bed_c(), machine::ambient_celsius + 5);
}

TEST_F(PrinterTest, heats_nothing_without_the_supply) {
  machine::PrinterOptions options;
  machine::add_fault(options.faults, "bed-heater-stuck-on@5");
  make(options);
  chip.plan(1, sim::OutputPins::heater_bit, true);
  simulation.run_until(rate.clocks(30));
  EXPECT_NEAR(printer->hotend_c(), machine::ambient_celsius, 0.1);
  EXPECT_NEAR(printer->bed_c(), machine::ambient_celsius, 0.1);
}

TEST_F(PrinterTest, charges_the_capacitor_of_a_sensor_in_the_time_that_its_resistor_takes) {
  make();
  const unsigned drive = sim::OutputPins::sensor_bit,
                 level = drive + sim::OutputPins::sensor_level_bit;
  // Through the high reference, 10 kOhm and 68 nF +- 10 %: ln 2 * R * C to half of the supply.
  chip.plan(100, drive + 2, true);
  chip.plan(100, level + 2, true);
  simulation.run_until(100);
  EXPECT_EQ(chip.inputs().sense & 1, 0);
  while ((chip.inputs().sense & 1) == 0 && simulation.now() < 10'000) {
    simulation.run_until(simulation.now() + 1);
  }
  const double nominal = 0.693 * 10'000 * 68e-9 * 4e6;
  EXPECT_NEAR(static_cast<double>(simulation.now() - 100), nominal, 0.13 * nominal);
}

TEST_F(PrinterTest, is_recorded_from_the_file_to_the_results) {
  make();
  enable_motors();
  const auto commands = devices::parse_gcode_text("G28\nG1 X1 Y0.5\nM104 S200\nM999\n", "test");
  devices::FileHost host(*commands, printer->serial_line(), rate);
  simulation.attach(host, {});
  report::Recorder recorder(*printer, host, simulation, {});
  chip.queue = {.underruns = 3, .guard_stall_clocks = 4, .depth = 0, .max_depth = 5};
  chip.firmware = [this](const std::string& line) -> std::string {
    const sim::Clock now = chip.now();
    if (line.contains("G28")) {
      const sim::Clock end = steps(now, 0, -printer->axis(0).position());
      const sim::Clock last = steps(end, 1, -printer->axis(1).position());
      homed_at = last;
      return "echo:busy: processing\n";
    }
    if (line.contains("G1")) {
      steps(now, 0, 80);
      steps(now + 2000, 1, 40);
    }
    return line.contains("M999") ? "echo:Unknown command: \"M999\"\nok\n" : "ok\n";
  };
  simulation.run_until(rate.clocks(1.2));
  ASSERT_GT(homed_at, 0U);
  simulation.run_until(homed_at);
  chip.say("ok\n");
  simulation.run_until(homed_at + rate.clocks(2));

  EXPECT_EQ(host.state(), devices::HostState::completed);
  const report::Results results = recorder.results({});
  EXPECT_EQ(results.commands_executed, 3U);
  EXPECT_EQ(results.commands_refused, 1U);
  EXPECT_EQ(results.axes[0].steps_forward, 80U);
  EXPECT_EQ(results.axes[0].final_position_steps, 80);
  EXPECT_EQ(results.axes[0].illegal_pulses, 0U);
  EXPECT_EQ(results.axes[1].final_position_mm, 0.5);
  EXPECT_EQ(results.axes[0].max_step_rate_hz, 1000);
  EXPECT_EQ(results.hotend.target_c, 200);
  EXPECT_EQ(results.underruns, 3U);
  EXPECT_EQ(results.max_queue_depth, 5U);
  EXPECT_EQ(results.points_reached + results.points_missed, 1U);
  ASSERT_FALSE(results.messages.empty());
  EXPECT_EQ(results.messages.back().text, "echo:Unknown command: \"M999\"");
  EXPECT_EQ(results.messages.back().file_line, 4U);
}

TEST_F(PrinterTest, measures_the_stack_by_its_paint) {
  sim::ElfImage image;
  EXPECT_EQ(report::stack_peak_bytes(image, chip), 0U);
  image.symbols = {{"_stack_bottom", 0x8000'0100}, {"_stack_top", 0x8000'0200}};
  for (std::uint32_t address = 0x8000'0100; address < 0x8000'01c0; address += 4) {
    chip.write_memory(address, 0xA5A5'A5A5);
  }
  EXPECT_EQ(report::stack_peak_bytes(image, chip), 0x40U);
}

TEST(FaultPlan, reads_every_form_and_refuses_others_with_help) {
  machine::FaultPlan plan;
  for (const char* text :
       {"hotend-open@30", "bed-short@1.5", "hotend-heater-stuck-on@0", "z-end-stop-never-opens",
        "serial=0.001", "hotend-frozen@60", "bed-drifting@7", "hotend-detached@8", "replies=0.002",
        "cable-pulled=3@20.5", "y-end-stop-bounces", "bed-capacitor-lost@4",
        "hotend-capacitor=1.5@9"}) {
    EXPECT_NO_THROW(machine::add_fault(plan, text)) << text;
  }
  EXPECT_EQ(plan.sensors.size(), 2U);
  EXPECT_EQ(plan.sensors[1].seconds, 1.5);
  EXPECT_EQ(plan.heaters.size(), 1U);
  EXPECT_EQ(plan.beads.size(), 3U);
  EXPECT_EQ(plan.beads[1].where, machine::Heated::bed);
  EXPECT_EQ(plan.beads[1].fault, plants::BeadFault::drifting);
  EXPECT_EQ(plan.end_stops[2], devices::EndStopFault::never_opens);
  EXPECT_EQ(plan.corrupted_bytes, 0.001);
  EXPECT_EQ(plan.corrupted_replies, 0.002);
  EXPECT_EQ(plan.end_stops[1], devices::EndStopFault::bounces);
  ASSERT_EQ(plan.cable.size(), 1U);
  EXPECT_EQ(plan.cable[0].from_seconds, 20.5);
  EXPECT_EQ(plan.cable[0].for_seconds, 3);
  ASSERT_EQ(plan.capacitors.size(), 2U);
  EXPECT_EQ(plan.capacitors[0].where, machine::Heated::bed);
  EXPECT_EQ(plan.capacitors[0].factor, 0);
  EXPECT_EQ(plan.capacitors[1].seconds, 9);
  EXPECT_EQ(plan.capacitors[1].factor, 1.5);
  for (const char* text : {"", "hotend", "hotend-open@x", "e-end-stop-never-opens", "serial=2",
                           "hotend-open@inf", "hotend-open@1e300", "cable-pulled=inf@1"}) {
    EXPECT_THROW(machine::add_fault(plan, text), std::invalid_argument) << text;
  }
}

std::string complaint_about(const char* fault) {
  machine::FaultPlan plan;
  try {
    machine::add_fault(plan, fault);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FaultPlan, says_what_is_wrong_with_a_value) {
  using testing::HasSubstr;
  for (const char* text : {"replies=1.1", "replies=", "serial=-1", "serial=x"}) {
    EXPECT_THAT(complaint_about(text), HasSubstr("a share is 0 to 1")) << text;
  }
  for (const char* text : {"cable-pulled=3", "cable-pulled=0@3", "cable-pulled=x@3",
                           "cable-pulled=3@", "cable-pulled=-1@3"}) {
    EXPECT_THAT(complaint_about(text), HasSubstr("cable-pulled=3@20")) << text;
  }
  for (const char* text :
       {"hotend-capacitor=0@3", "hotend-capacitor=1.5", "hotend-capacitor=11@3"}) {
    EXPECT_THAT(complaint_about(text), HasSubstr("hotend-capacitor=0.5@30")) << text;
  }
  EXPECT_THAT(complaint_about("cable-pulled"), HasSubstr("no such fault"));
}

}  // namespace
