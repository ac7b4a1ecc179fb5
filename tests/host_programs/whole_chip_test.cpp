// SPDX-License-Identifier: Apache-2.0
// All kinds of hosts and their errors against the whole chip: every line is accepted once and in
// order, and afterwards a fresh host can print.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>

#include "gcode/parser.hpp"
#include "tests/host_programs/served_chip.hpp"

namespace host_programs {
namespace {

using host_link::test::Eavesdropper;
using host_link::test::HostModel;

// Short moves away from where the axes stand, with what slicers put between.
std::vector<std::string> job(int lines) {
  std::mt19937_64 random(5);
  std::vector<std::string> result{"G90", "G1 F6000"};
  for (int i = 2; i < lines; ++i) {
    if (i % 10 == 9) {
      result.push_back(i % 20 == 9 ? "M105" : "M117 Layer G1 X5");
      continue;
    }
    result.push_back("G1 X" + std::to_string(random() % 4) + "." + std::to_string(random() % 1000) +
                     " Y" + std::to_string(random() % 4) + ".5");
  }
  return result;
}

// STEPFABRIC_NOISY_LINES: lines of the job, for long runs by hand.
int lines_of_job(int usual) {
  const char* const text = std::getenv("STEPFABRIC_NOISY_LINES");
  return text == nullptr ? usual : std::stoi(text);
}

using MakeHost = std::function<std::unique_ptr<HostModel>(std::vector<std::string>)>;

struct Taken {
  std::vector<std::string> lines;
  std::vector<Edge> edges;
  std::uint64_t resends;
};

Taken print_over_a_line(const MakeHost& make, const std::vector<std::string>& lines, double faults,
                        std::uint64_t seed, Eavesdropper& eavesdropper) {
  ServedChip chip;
  const auto host = make(lines);
  const double timeout = 30 + 0.5 * static_cast<double>(lines.size());
  EXPECT_TRUE(chip.converse(*host, faults, seed, timeout, eavesdropper)) << "the host hangs";
  EXPECT_LE(chip.longest_wait(), faults == 0 ? 2.0 : 5.0);
  Taken taken{{}, std::move(chip.edges), chip.watch->resends()};
  const int first = host->first_number();
  for (const auto& line : chip.accepted) {
    if (!line.number || line.text.starts_with("M110")) continue;
    const auto place = static_cast<std::size_t>(*line.number - first);
    if (place < taken.lines.size()) {
      // What was no command has been requested again, with the lines after it.
      EXPECT_FALSE(gcode::parse(taken.lines[place]).has_value()) << taken.lines[place];
      taken.lines.resize(place);
    }
    EXPECT_EQ(place, taken.lines.size());
    taken.lines.push_back(line.text);
  }
  return taken;
}

void expect_the_same_pulses_over_a_noisy_line(const MakeHost& make) {
  const std::vector<std::string> lines = job(lines_of_job(150));
  Eavesdropper eavesdropper(host_link::test::framed_lines(lines));
  const Taken clean = print_over_a_line(make, lines, 0, 1, eavesdropper);
  EXPECT_EQ(clean.lines, lines);
  EXPECT_EQ(clean.resends, 0u);
  EXPECT_FALSE(clean.edges.empty());
  const Taken noisy = print_over_a_line(make, lines, 1e-3, 2, eavesdropper);
  EXPECT_EQ(noisy.lines, lines);
  EXPECT_GT(noisy.resends, 0u);
  EXPECT_TRUE(noisy.edges == clean.edges);
}

TEST(noisy_line, printcore_makes_the_pulses_of_a_clean_one) {
  expect_the_same_pulses_over_a_noisy_line(host_link::test::printcore);
}

TEST(noisy_line, octoprint_makes_the_pulses_of_a_clean_one) {
  expect_the_same_pulses_over_a_noisy_line(host_link::test::octoprint);
}

TEST(noisy_line, cura_makes_the_pulses_of_a_clean_one) {
  expect_the_same_pulses_over_a_noisy_line(host_link::test::cura);
}

// One byte in a hundred: a fault in every fourth line or reply.
void expect_only_corruption_that_checksums_miss(const MakeHost& make) {
  const std::vector<std::string> lines = job(lines_of_job(150));
  // printcore does not hear a Resend for its last lines.
  constexpr std::size_t unguarded_lines = 2;
  Eavesdropper eavesdropper(host_link::test::framed_lines(lines));
  const Taken noisy = print_over_a_line(make, lines, 1e-2, 3, eavesdropper);
  EXPECT_GT(noisy.resends, 10u);
  ASSERT_GE(noisy.lines.size(), lines.size() - unguarded_lines);
  ASSERT_LE(noisy.lines.size(), lines.size());
  for (std::size_t i = 0; i < noisy.lines.size(); ++i) {
    if (noisy.lines[i] == lines[i]) continue;
    EXPECT_TRUE(eavesdropper.could_not_be_seen(noisy.lines[i]))
        << noisy.lines[i] << " taken for " << lines[i];
    EXPECT_TRUE(gcode::parse(noisy.lines[i]).has_value()) << noisy.lines[i];
    std::printf("  the checksum of \"%s\" matches, sent was \"%s\"\n", noisy.lines[i].c_str(),
                lines[i].c_str());
  }
}

TEST(very_noisy_line, corrupts_lines_of_printcore_only_where_the_checksum_matches) {
  expect_only_corruption_that_checksums_miss(host_link::test::printcore);
}

TEST(very_noisy_line, corrupts_lines_of_octoprint_only_where_the_checksum_matches) {
  expect_only_corruption_that_checksums_miss(host_link::test::octoprint);
}

TEST(very_noisy_line, corrupts_lines_of_cura_only_where_the_checksum_matches) {
  expect_only_corruption_that_checksums_miss(host_link::test::cura);
}

TEST(misbehaving_hosts, one_that_is_gone_in_the_midst_of_a_numbered_line) {
  ServedChip chip;
  chip.ask(0, "M110 N0");
  chip.send("N1 G1 X50 F60");
  chip.finish_sending();
  chip.expect_that_a_fresh_host_prints();
}

TEST(misbehaving_hosts, one_that_floods_without_waiting) {
  ServedChip chip;
  std::string flood;
  while (flood.size() < 100'000) flood += "G1 X10 Y10 F3000\n";
  chip.send(flood);
  chip.finish_sending();
  EXPECT_LT(chip.accepted.size(), flood.size() / 17);
  for (const auto& line : chip.accepted) EXPECT_EQ(line.text, "G1 X10 Y10 F3000");
  chip.expect_that_a_fresh_host_prints();
}

TEST(misbehaving_hosts, one_that_floods_a_megabyte_without_waiting) {
  ServedChip chip;
  std::string flood;
  while (flood.size() < 1'000'000) flood += "G1 X10 Y10 F3000\n";
  chip.send(flood);
  chip.finish_sending();
  for (const auto& line : chip.accepted) EXPECT_EQ(line.text, "G1 X10 Y10 F3000");
  chip.expect_that_a_fresh_host_prints();
}

TEST(misbehaving_hosts, one_with_a_line_of_64_kib) {
  ServedChip chip;
  chip.send("G1 X1" + std::string(65'536, '0') + "\n");
  chip.finish_sending();
  chip.expect_that_a_fresh_host_prints();
}

TEST(misbehaving_hosts, one_that_sends_nul_bytes) {
  ServedChip chip;
  chip.send(std::string(5'000, '\0'));
  chip.finish_sending();
  chip.expect_that_a_fresh_host_prints();
}

TEST(misbehaving_hosts, one_at_the_wrong_speed) {
  ServedChip chip;
  for (const std::uint32_t baud : {115'200u, 57'600u, 500'000u, 9'600u}) {
    chip.printer->serial_line().set_baud(chip.simulation.now(), baud);
    for (int i = 0; i < 5; ++i) chip.send("\nN0 M110 N0*125\nM105\n");
    chip.finish_sending();
  }
  EXPECT_TRUE(chip.edges.empty());
  chip.printer->serial_line().set_baud(chip.simulation.now(), 250'000);
  chip.expect_that_a_fresh_host_prints();
}

TEST(misbehaving_hosts, one_that_is_killed_during_m109_leaves_a_printer_that_cools_down) {
  ServedChip chip(196, 22);
  chip.ask(0, "M110 N0");
  chip.ask(1, "M86 S3");
  chip.send("N2 M109 S200*104\n");
  double hottest = 0;
  for (int i = 0; i < 40; ++i) {
    chip.run(1.0);
    hottest = std::max(hottest, chip.printer->hotend_c());
  }
  EXPECT_GT(hottest, 198.0);
  EXPECT_LT(hottest, 205.0);
  // The wait is over, the host has been silent for three seconds: the heat is off.
  EXPECT_LT(chip.printer->hotend_c(), 195.0);
  chip.expect_that_a_fresh_host_prints();
}

// As a port that is closed and opened again at once: the line is low for a while, wherever the
// firmware is, and rests before the next host writes.
TEST(misbehaving_hosts, ones_that_hang_up_within_an_answer_leave_the_next_one_s_line_whole) {
  ServedChip chip;
  for (int phase = 0; phase < 40; ++phase) {
    chip.run(0.5);
    chip.send("M105\n");
    chip.run(0.0007 + 0.00023 * phase);
    chip.printer->serial_line().hang_up(chip.simulation.now(), chip.rate.clocks(0.02));
    chip.run(0.12);
    chip.send("M118 here\n");
    // After what is left of the answer.
    std::string said = chip.reply(1);
    while (said.starts_with("ok") || said.starts_with("T:")) said = chip.reply(1);
    EXPECT_EQ(said, "here") << phase;
  }
}

}  // namespace
}  // namespace host_programs
