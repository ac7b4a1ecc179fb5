// SPDX-License-Identifier: Apache-2.0
// M220 acts in its place, or at once if a person sends it; pauses act on the move under way. Where
// it goes stays.
#include <gtest/gtest.h>

#include <string>

#include "registers/step_generator_registers.hpp"
#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::size_t x = 0;

// On its way to 100 mm at 10 mm/s for about a second.
void set_out(Printer& printer) {
  printer.talk("-> G28\n<- ok\n-> G1 X100 F600\n<- ok");
  printer.run(1.1);
}

// A host that numbers its lines, as all do that print a file.
class Job {
 public:
  explicit Job(Printer& printer) : printer_(printer) { line("M110"); }
  void line(const std::string& command) { person("-> " + framed(command) + "\n<- ok"); }
  // Sent between the lines, without a number. An ok that was repeated for a host that seemed to
  // wait is not meant.
  void person(const std::string& dialogue) {
    printer_.chip.from_firmware.clear();
    printer_.talk(dialogue);
  }
  std::string framed(const std::string& command) {
    const std::string text = "N" + std::to_string(number_++) + " " + command;
    unsigned sum = 0;
    for (const char byte : text) sum ^= static_cast<unsigned char>(byte);
    return text + "*" + std::to_string(sum);
  }

 private:
  Printer& printer_;
  int number_{-1};
};

// On its way to 100 mm at 10 mm/s for about a second, by the lines of a job.
Job job_under_way(Printer& printer) {
  Job job(printer);
  job.line("G28");
  job.line("G1 X100 F600");
  printer.run(1.1);
  return job;
}

// How far X moves in this time, in mm.
double way(Printer& printer, double seconds) {
  const double before = printer.mm(x);
  printer.run(seconds);
  return printer.mm(x) - before;
}

TEST(pace, a_factor_in_a_job_holds_for_the_lines_behind_it) {
  Printer printer;
  Job job = job_under_way(printer);
  job.line("M220 S50");
  job.line("G1 X120");
  job.line("M220 S200");
  job.line("G1 X140");
  EXPECT_NEAR(way(printer, 8), 80, 1);
  printer.run(1.2);
  EXPECT_NEAR(way(printer, 2), 10, 0.2);
  printer.run(1.88);
  EXPECT_NEAR(way(printer, 0.8), 16, 0.3);
  job.line("M400");
  EXPECT_EQ(printer.chip.position[x], 11'200);
}

TEST(pace, without_line_numbers_a_factor_holds_for_the_lines_behind_it) {
  Printer printer;
  set_out(printer);
  printer.talk("-> M220 S50\n<- ok\n-> G1 X0\n<- ok");
  EXPECT_NEAR(way(printer, 4), 40, 0.5);
  printer.run(6);
  EXPECT_NEAR(way(printer, 4), -20, 0.5);
}

TEST(pace, a_factor_of_a_person_slows_the_move_under_way_and_those_behind) {
  Printer printer;
  Job job = job_under_way(printer);
  job.line("G1 X150");
  job.person("-> M220 S50\n<- ok");
  EXPECT_NEAR(way(printer, 4), 20, 0.5);
  job.line("G1 X0");
  job.person("-> M220\n<- FR:50%\n<- ok\n-> M220 S100\n<- ok");
  EXPECT_NEAR(way(printer, 4), 40, 0.5);
  job.person("-> M220 S25\n<- ok");
  job.line("M400");
  EXPECT_EQ(printer.chip.position[x], 0);
}

// The planner and the queue are full, and the line that waits would run long after it.
TEST(pace, a_factor_of_a_person_does_not_wait_for_the_lines_before_it) {
  Printer printer;
  Job job = job_under_way(printer);
  constexpr int full = motion::Planner::capacity;
  for (int i = 1; i <= full; ++i) job.line("G1 X" + std::to_string(100 + i));
  printer.send(job.framed("G1 X170"));
  printer.send(job.framed("G1 X180"));
  printer.run(0.1);
  printer.send("M220 S50 ; slower");
  printer.run(0.1);
  EXPECT_NEAR(way(printer, 4), 20, 0.5);
  EXPECT_EQ(printer.reply(0.1), std::nullopt);
  printer.talk("<- ok\n<- ok\n<- ok");
}

TEST(pace, a_factor_of_a_person_slows_the_last_move_of_a_job_however_long_it_takes) {
  Printer printer;
  Job job(printer);
  job.line("G28");
  job.line("G1 X190 F300");
  EXPECT_NEAR(way(printer, 25), 125, 2);
  job.person("-> M220 S20\n<- ok");
  EXPECT_NEAR(way(printer, 10), 10, 0.2);
}

TEST(pace, a_factor_of_a_person_above_100_is_for_the_lines_to_come) {
  Printer printer;
  Job job = job_under_way(printer);
  job.person("-> M220 S300\n<- ok");
  EXPECT_NEAR(way(printer, 2), 20, 0.5);
  job.line("M400");
  job.line("G1 X0");
  printer.run(2);
  EXPECT_NEAR(printer.mm(x), 40, 2);
}

// Lines with 300 % of it, and limits that some of them reach, are slowed to what is requested now.
TEST(pace, a_factor_of_a_person_below_that_of_the_lines_under_way_slows_them_to_it) {
  Printer printer;
  Job job(printer);
  job.line("G28");
  job.line("M220 S300");
  job.line("G1 X100 F600");
  printer.run(1.1);
  job.person("-> M220 S50\n<- ok");
  EXPECT_NEAR(way(printer, 4), 20, 0.5);
  job.line("G1 X200 F24000");
  job.person("-> M220\n<- FR:50%\n<- ok\n");
  job.line("G4 P1");
  EXPECT_EQ(printer.chip.position[x], 16'000);
  // 200 mm/s is what the axis can do: half of it, not the sixth.
  job.line("G1 X0");
  printer.run(0.6);
  EXPECT_NEAR(way(printer, 0.5), -50, 2);
}

TEST(pace, a_factor_in_a_job_ends_that_of_a_person_where_it_stands) {
  Printer printer;
  Job job = job_under_way(printer);
  job.person("-> M220 S50\n<- ok");
  job.line("M220 S80");
  job.line("G1 X0");
  EXPECT_NEAR(way(printer, 4), 20, 0.5);
  printer.run(14.2);
  EXPECT_NEAR(way(printer, 5), -40, 0.5);
  job.person("-> M220\n<- FR:80%\n<- ok");
}

TEST(pace, m220_keeps_and_restores_the_factor) {
  Printer printer;
  printer.talk(R"(
    -> M220 S70
    <- ok
    -> M220 B S120
    <- ok
    -> M220
    <- FR:120%
    <- ok
    -> M220 R
    <- ok
    -> M220
    <- FR:70%
    <- ok
    -> M220 S0
    <* not executed
    <- ok
    -> M220 S1000
    <* not executed
    <- ok
    -> M220
    <- FR:70%
    <- ok
  )");
}

TEST(pace, a_line_that_comes_after_m220_is_not_slowed_twice) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> M220 S50\n<- ok\n-> G1 X100 F1200\n<- ok");
  printer.run(5);
  EXPECT_NEAR(printer.mm(x), 50, 2);
}

TEST(pace, many_lines_at_a_tenth_of_their_speed_come_without_an_underrun) {
  Printer printer;
  Job job(printer);
  job.line("G28");
  printer.talk("-> M220 S10\n<- ok");
  job.line("G91");
  for (int i = 0; i < 60; ++i) job.line("G1 X0.5 F6000");
  job.line("M400");
  EXPECT_EQ(printer.chip.position[x], 2400);
  EXPECT_EQ(printer.chip.underruns, 0u);
}

TEST(pace, homing_runs_at_its_own_speed) {
  const auto seconds_after = [](const char* dialogue) {
    Printer printer;
    printer.talk(dialogue);
    const auto begin = printer.chip.time;
    printer.talk("-> G28 X\n<- ok");
    return static_cast<double>(printer.chip.time - begin) / clock_hz;
  };
  EXPECT_NEAR(seconds_after("-> M220 S10\n<- ok"), seconds_after("-> M220 S100\n<- ok"), 0.1);
}

TEST(pace, a_pause_holds_the_move_where_it_is_until_resume) {
  Printer printer;
  set_out(printer);
  printer.talk("-> //action:pause\n<- ok");
  printer.run(0.1);
  const auto held_at = printer.chip.position[x];
  EXPECT_LT(printer.mm(x), 20);
  printer.run(5);
  EXPECT_EQ(printer.chip.position[x], held_at);
  printer.talk("-> //action:resume\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 8000);
}

TEST(pace, a_resume_goes_on_at_the_speed_of_m220) {
  Printer printer;
  job_under_way(printer);
  printer.talk("-> M220 S50\n<- ok\n-> //action:pause\n<- ok");
  printer.run(1);
  const double before = printer.mm(x);
  printer.talk("-> //action:resume\n<- ok");
  printer.run(4);
  EXPECT_NEAR(printer.mm(x) - before, 20, 0.5);
}

TEST(pace, a_cancel_ends_the_hold_and_the_move) {
  Printer printer;
  set_out(printer);
  printer.talk("-> //action:pause\n<- ok\n-> //action:cancel\n<- ok\n-> G91\n<- ok");
  const auto stopped_at = printer.chip.position[x];
  printer.talk("-> G1 X1\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], stopped_at + 80);
}

TEST(pace, every_pass_feeds_the_watchdog_of_motion) {
  Printer printer;
  set_out(printer);
  EXPECT_EQ(printer.chip.read(registers::step_generator::Watchdog::address), clock_hz / 5);
  const auto before = printer.chip.motion_watchdog_feeds;
  printer.run(1);
  EXPECT_GE(printer.chip.motion_watchdog_feeds - before, 100u);
}

TEST(pace, a_stop_by_the_watchdog_halts_the_printer) {
  Printer printer;
  set_out(printer);
  printer.chip.stop_by_watchdog();
  printer.talk("<- Error:Motion stopped by its watchdog\n<- Error:Printer halted. kill() called!");
  EXPECT_EQ(printer.chip.motors, 0u);
}

}  // namespace
}  // namespace application_test
