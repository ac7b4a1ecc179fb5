// SPDX-License-Identifier: Apache-2.0
// Random commands around G10 and G11, held against a small model of what they may do to Z and E.
#include <format>
#include <random>

#include "tests/application/two_tools.hpp"

namespace application_test {
namespace {

constexpr int per_mm = 2560, travel = 110 * per_mm, extruder_per_mm = 500, tool_offset = 640;

class Lift : public testing::TestWithParam<bool> {
 protected:
  Lift() : printer(GetParam() ? machine_with_two_tools() : machine_under_test()) {
    printer.chip.heaters[0].celsius = printer.chip.heaters[2].celsius = 200;
    for (const char* line : {"M203 Z50", "M201 Z2000", "G28", "M104 S200"}) accepted(line);
    if (GetParam()) accepted("M104 S200 T1");
    accepted("G1 X80 Y80 F9000");
  }
  int pick(int least, int most) { return std::uniform_int_distribution(least, most)(random); }
  // Steps of a multiple of 0.05 mm.
  int height(int least, int most) { return pick(least * 20, most * 20) * (per_mm / 20); }
  static std::string mm(int steps) { return std::format("{:.10f}", 1.0 * steps / per_mm); }
  bool accepted(const std::string& line) {
    log += line + "\n";
    printer.send(line);
    bool good = true;
    for (auto said = printer.reply(); said != "ok"; said = printer.reply()) {
      if (!said) return false;
      good = good && !said->contains("not executed") && !said->contains("prevented");
    }
    return good;
  }
  bool executed(const std::string& line) {
    const bool good = accepted(line);
    return accepted("M400") && good;
  }
  int z() const { return printer.chip.position[2]; }
  int e() const { return printer.chip.position[3 + tool]; }
  double host_z() {
    printer.send("M114");
    const std::string said = printer.reply().value_or("");
    EXPECT_EQ(printer.reply(), "ok");
    return std::strtod(said.c_str() + std::min(said.find("Z:"), said.size() - 2) + 2, nullptr);
  }
  // A line that leads Z there: refused exactly where the nozzle, or that of G11, would leave.
  void lead(const std::string& line, int target) {
    const bool may = target >= lift && target <= travel;
    const int expected = may ? target : z();
    EXPECT_EQ(executed(line), may);
    EXPECT_EQ(z(), expected);
  }
  void jump() {
    if (lift != 0) left = named ? 0 : lift;
    lift = 0;
  }
  void retract() {
    const int before = z(), filament = e();
    const bool draws = !retracted[tool], lifts = draws && lift == 0;
    const bool may = !lifts || before + set_lift <= travel;
    EXPECT_EQ(executed("G10"), may);
    EXPECT_EQ(z() - before, may && lifts ? set_lift : 0);
    EXPECT_EQ(filament - e(), may && draws ? set_length : 0);
    if (!may || !draws) return;
    retracted[tool] = true, drawn[tool] = set_length;
    if (lifts) shift += set_lift - left, left = 0, lift = set_lift, named = false;
  }
  void recover() {
    const int before = z(), filament = e();
    EXPECT_TRUE(executed("G11"));
    EXPECT_EQ(before - z(), lift);
    EXPECT_EQ(e() - filament, retracted[tool] ? drawn[tool] : 0);
    shift -= lift + left;
    lift = left = 0, retracted[tool] = false;
  }
  // In mid-line.
  void stop(const std::string& line) {
    const bool may = accepted(line), draws = may && line == "G10" && !retracted[tool];
    if (draws) retracted[tool] = true, drawn[tool] = set_length;
    printer.run(pick(0, 150) / 1000.0);
    EXPECT_TRUE(executed("M410"));
    if (!draws || lift != 0) return jump();
    const double lifted = 1.0 * (z() - shift - set_lift + left) / per_mm;
    const bool planned = std::abs(host_z() - lifted) < 0.006;
    const int kept = planned ? set_lift : 0;
    shift += kept - left, left = kept, named = false;
  }
  void step() {
    const int to = pick(0, 9) == 0 ? height(100, 111) : height(-2, 4), by = height(-2, 2);
    const int kind = pick(0, 14), x = pick(60, 120);
    if (kind <= 4) return kind <= 2 ? retract() : recover();
    if (kind == 5) return lead(std::format("G1 X{} Z{} F9000", x, mm(to - shift)), to);
    if (kind == 8) return lead("G27 P1", 20 * per_mm);
    if (kind == 11) return stop(pick(0, 1) == 0 ? "G10" : std::format("G1 X{} F6000", x));
    if (kind == 6) {
      accepted("G91");
      lead(std::format("G{} I{} Z{} F9000", pick(2, 3), pick(1, 9), mm(by)), z() + by);
      EXPECT_TRUE(accepted("G90"));
    } else if (kind == 7) {
      if (z() + by >= lift && z() + by <= travel) shift += by;
      lead("M290 Z" + mm(by), z() + by);
    } else if (kind == 9) {
      EXPECT_TRUE(accepted("G92 Z" + mm(to)));
      left = 0, named = true, shift = z() - to;
    } else if (kind == 10) {
      const bool all = pick(0, 1) == 0;
      EXPECT_TRUE(executed(all ? "G28" : "G28 X"));
      jump();
      if (all) shift = static_cast<int>(tool) * tool_offset, left = 0;
      EXPECT_TRUE(executed("G1 X80 Y80 F9000"));
    } else if (kind == 12) {
      executed(pick(0, 1) == 0 ? "G60 S1" : "G61 S1 Z F5000");
    } else if (kind == 13) {
      set_lift = height(0, pick(0, 9) == 0 ? 40 : 2);
      set_length = pick(0, 5) * extruder_per_mm;
      accepted(std::format("M207 S{} Z{}", set_length / extruder_per_mm, mm(set_lift)));
    } else if (GetParam()) {
      shift -= static_cast<int>(tool) * tool_offset;
      tool = pick(0, 1) == 0 ? 0 : 1;
      executed(std::format("T{}{}", tool, pick(0, 3) == 0 ? " S1" : ""));
      shift += static_cast<int>(tool) * tool_offset;
    }
  }

  Printer printer;
  std::mt19937 random{20};
  std::string log;
  // Valid; void, but in the host's Z; the machine's Z above the host's.
  int lift{}, left{}, shift{};
  bool named{}, retracted[2]{};  // by G92 since Z was lifted; each tool
  int drawn[2]{}, set_lift{}, set_length{3 * extruder_per_mm};
  std::size_t tool{};
};

TEST_P(Lift, is_always_taken_back_within_the_travel) {
  for (int i = 0; i < 10'000; ++i) {
    step();
    EXPECT_TRUE(z() >= lift && z() <= travel);
    EXPECT_NEAR(host_z(), 1.0 * (z() - shift) / per_mm, 0.006);
    ASSERT_FALSE(HasFailure()) << i << ":\n" << log.substr(std::max(log.size(), 400UZ) - 400);
  }
}

INSTANTIATE_TEST_SUITE_P(With, Lift, testing::Bool());

}  // namespace
}  // namespace application_test
