// SPDX-License-Identifier: Apache-2.0
// M220 in the middle of a print on the whole chip: where it holds, and that it breaks no limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "sim/devices/file_host.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr sim::Clock second = clock_hz;

struct Recorder : devices::StepListener {
  void stepped(const devices::StepEdge& edge) override { edges.push_back(edge); }
  std::vector<devices::StepEdge> edges;
};

// Lines that a person sends during the job, with the time after its first step.
struct Remark {
  sim::Clock after;
  std::string text;
};

std::vector<devices::StepEdge> print(const std::string& gcode, std::vector<Remark> remarks = {}) {
  sim::VerilatedChip chip(clock_hz);
  tests::LoadedPrinter loaded(chip, clock_hz, 25, 25);
  sim::Simulation& simulation = loaded.simulation;
  machine::Printer& printer = loaded.printer;
  Recorder recorder;
  printer.add_step_listener(recorder);
  devices::FileHost host(devices::parse_gcode_text(gcode, "test").value(), printer.serial_line(),
                         simulation.rate());
  simulation.attach(host, {});
  // The ok to a remark is one more for the host, so that it ends too early.
  sim::Clock last_edge = 0;
  while ((!host.ended() || simulation.now() < last_edge + second) &&
         simulation.now() < 40 * second) {
    simulation.run_until(simulation.now() + second / 200);
    if (recorder.edges.empty()) continue;
    last_edge = recorder.edges.back().clock;
    const sim::Clock since = simulation.now() - recorder.edges.front().clock;
    if (remarks.empty() || since < remarks.front().after) continue;
    printer.serial_line().send(simulation.now(), remarks.front().text + "\n");
    remarks.erase(remarks.begin());
  }
  EXPECT_EQ(host.state(), devices::HostState::completed) << host.fault();
  EXPECT_EQ(chip.queue_statistics().underruns, 0u);
  EXPECT_TRUE(remarks.empty());
  return recorder.edges;
}

// The speed between two edges of X, in mm/s.
double speed(const devices::StepEdge& from, const devices::StepEdge& to) {
  constexpr double steps_per_mm = 80;
  const double seconds = static_cast<double>(to.clock - from.clock) / clock_hz;
  return static_cast<double>(to.position - from.position) / steps_per_mm / seconds;
}

std::vector<devices::StepEdge> of_x(std::vector<devices::StepEdge> edges) {
  std::erase_if(edges, [](const auto& edge) { return edge.axis != 0; });
  return edges;
}

// The largest acceleration of X that its edges show while it goes one way: from speeds over 4 ms
// each, in which a clock more or less is 2 % of 1000 mm/s^2.
double largest_acceleration(const std::vector<devices::StepEdge>& x) {
  constexpr sim::Clock apart = second / 250;
  double largest = 0;
  std::size_t middle = 0, last = 0;
  for (std::size_t first = 0; first < x.size(); ++first) {
    const auto next = [&x](std::size_t from, std::size_t least) {
      std::size_t index = std::max(from, least);
      while (index < x.size() && x[index].clock < x[from].clock + apart) ++index;
      return index;
    };
    middle = next(first, middle);
    if (middle == x.size()) break;
    last = next(middle, last);
    if (last == x.size()) break;
    const auto ways = [&x](std::size_t from, std::size_t to) {
      return std::abs(x[to].position - x[from].position) == static_cast<std::int64_t>(to - from);
    };
    if (!ways(first, last)) continue;
    const double seconds = static_cast<double>(x[last].clock - x[first].clock) / 2 / clock_hz;
    const double change = speed(x[middle], x[last]) - speed(x[first], x[middle]);
    largest = std::max(largest, std::abs(change) / seconds);
  }
  return largest;
}

TEST(pace, m220_s50_of_a_person_gives_the_same_pulses_in_the_same_order_only_later) {
  const std::string gcode =
      "G91\nG1 X12 Y5 F3000\nG1 X-2 Y7.3\nG1 X5.1 Y-1\nG1 X-8 Y-3\nG1 X9 Y4 Z0.02\n"
      "G1 X-6 Y-2\nG1 X4.2 Y1.9 F2400\n";
  const auto usual = print(gcode);
  const auto slowed = print(gcode, {{second / 20, "M220 S50"}});
  ASSERT_GT(usual.size(), 3000u);
  ASSERT_EQ(usual.size(), slowed.size());
  sim::Clock delay = 0;
  for (std::size_t i = 0; i < usual.size(); ++i) {
    const auto what = [](const devices::StepEdge& edge) {
      return std::tuple(edge.axis, edge.direction, edge.position);
    };
    ASSERT_EQ(what(usual[i]), what(slowed[i])) << i;
    const sim::Clock now =
        (slowed[i].clock - slowed[0].clock) + 4 - (usual[i].clock - usual[0].clock);
    ASSERT_LT(now, 20 * second) << i << ": sooner";
    ASSERT_GE(now + 4, delay) << i << ": caught up";
    delay = std::max(delay, now);
  }
  // It comes while the first line is made, so nearly all is made at half the speed.
  const sim::Clock duration = usual.back().clock - usual[0].clock;
  EXPECT_GT(delay, duration * 7 / 10);
  EXPECT_LE(delay, duration + 4);
}

TEST(pace, a_factor_in_the_file_holds_for_the_lines_behind_it_and_no_other) {
  std::string gcode = "G91\nM205 X0\n";
  for (int i = 0; i < 12; ++i) gcode += "G1 X2 F2400\n";
  gcode += "M220 S50\n";
  for (int i = 0; i < 24; ++i) gcode += "G1 X2\n";
  gcode += "M220 S150\n";
  for (int i = 0; i < 12; ++i) gcode += "G1 X2\n";
  const auto x = of_x(print(gcode));
  ASSERT_EQ(x.size(), 48u * 160);
  // Over 1 mm; with an acceleration of 1500 mm/s^2 speeds are reached within 1.2 mm.
  constexpr std::size_t millimetre = 80;
  for (std::size_t from = 0; from + millimetre < x.size(); from += millimetre / 4) {
    const double begin = static_cast<double>(from) / millimetre;
    const double at = speed(x[from], x[from + millimetre]);
    if (begin > 1.2 && begin < 24 - 2.2) {
      EXPECT_NEAR(at, 40, 0.1) << begin << " mm";
    } else if (begin > 24 && begin < 72 - 1) {
      EXPECT_NEAR(at, 20, 0.1) << begin << " mm";
    } else if (begin > 72 + 1.2 && begin < 96 - 2.4) {
      EXPECT_NEAR(at, 60, 0.1) << begin << " mm";
    }
  }
}

// Changes of M220 and holds at any moment of ramps and cruises, above what M204 allows nothing.
void expect_acceleration_kept(const std::string& there, const std::string& back, double part) {
  std::string gcode = "G91\nM205 X0 Y0\n";
  for (int i = 0; i < 7; ++i) gcode += "G1 " + there + " F9000\nG1 " + back + "\n";
  std::mt19937 random(static_cast<unsigned>(gcode.size()));
  std::vector<Remark> remarks;
  const auto later = [&random] { return second / 20 + random() % (second / 6); };
  for (sim::Clock after = later(); after < 3 * second; after += later()) {
    if (random() % 4 == 0) {
      remarks.push_back({after, "//action:pause"});
      after += later();
      remarks.push_back({after, "//action:resume"});
    } else {
      remarks.push_back(
          {after, "M220 S" + std::to_string(random() % 2 == 0 ? 100 : 20 + random() % 80)});
    }
  }
  const double largest = largest_acceleration(of_x(print(gcode, remarks))) / part;
  EXPECT_LT(largest, 1.02 * 1500);
  EXPECT_GT(largest, 0.98 * 1500);
}

TEST(pace, a_person_changes_no_acceleration_beyond_m204) {
  expect_acceleration_kept("X60", "X-60", 1);
}

TEST(pace, a_person_changes_no_acceleration_beyond_m204_on_two_axes) {
  expect_acceleration_kept("X50 Y50", "X-50 Y-50", std::sqrt(0.5));
}

}  // namespace
