// SPDX-License-Identifier: Apache-2.0
// What the chip does with the model of its processor, its whole netlist does again from any
// snapshot; what is not the same is found and named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "sim/replay/processor_snapshot.hpp"
#include "sim/replay/replay_model.hpp"
#include "tests/replay/recorded_run.hpp"

namespace {

using replay::Difference;
using replay::Interval;
using replay::Snapshot;
using testing::HasSubstr;

constexpr sim::Clock length = 200'000;
constexpr std::uint64_t step_pins = (1U << sim::axis_count) - 1;

class OpenReplayModel : public replay::ReplayModel {
 public:
  explicit OpenReplayModel(sim::Edges edges = sim::Edges::leaping)
      : ReplayModel(tests::recorded_clock_hz, false, edges) {}
  auto& root() { return *model_->rootp; }
  using ReplayModel::registers;
};

class ReplayTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { intervals_ = tests::recorded_run(20 * length, length); }
  static void TearDownTestSuite() { intervals_.clear(); }

  static std::ptrdiff_t steps_in(const Interval& interval) {
    std::uint64_t before = 0;
    return std::ranges::count_if(interval.outputs, [&](const replay::OutputChange& change) {
      const std::uint64_t steps = change.pins.word & step_pins;
      return (steps & ~std::exchange(before, steps)) != 0;
    });
  }
  static const Interval& busy_interval() {
    return *std::ranges::max_element(intervals_, {}, steps_in);
  }

  OpenReplayModel model_;
  inline static std::vector<Interval> intervals_;
};

std::string words(const std::optional<Difference>& difference) {
  return difference ? difference->what : "no difference";
}

TEST_F(ReplayTest, does_what_was_recorded_in_any_order) {
  ASSERT_GT(intervals_.size(), 15u);
  EXPECT_TRUE(intervals_.front().start->in_reset);
  EXPECT_GT(steps_in(busy_interval()), 20);
  for (const Interval& interval : intervals_) {
    EXPECT_EQ(words(model_.replay(interval)), "no difference") << interval.number;
  }
  std::ranges::reverse(intervals_);
  for (const Interval& interval : intervals_) {
    EXPECT_EQ(words(model_.replay(interval)), "no difference") << interval.number;
  }
  std::ranges::reverse(intervals_);
}

TEST_F(ReplayTest, does_what_was_recorded_without_leaps_and_rests) {
  OpenReplayModel model(sim::Edges::all);
  for (const Interval& interval : intervals_) {
    EXPECT_EQ(words(model.replay(interval)), "no difference") << interval.number;
  }
}

TEST_F(ReplayTest, finds_each_register_that_differs_without_leaps_and_rests) {
  OpenReplayModel model(sim::Edges::all);
  const Interval& interval = busy_interval();
  ASSERT_EQ(words(model.replay(interval)), "no difference");
  std::size_t place = 0;
  std::vector<std::string> ignored;
  for (const replay::Register& chip_register : model.registers()) {
    Snapshot end = *interval.end;
    place += chip_register.bytes;
    end.registers[place - 1] ^= 1;
    const std::string found = words(model.difference(end));
    if (found == "no difference") {
      ignored.emplace_back(chip_register.name);
    } else {
      EXPECT_THAT(found, HasSubstr(chip_register.name));
    }
  }
  // Written out, so that no other register is left out by its name alone.
  EXPECT_THAT(ignored, testing::UnorderedElementsAre(
                           "printer_core__DOT__machine_timer__DOT__seen_cycles_q",
                           "printer_core__DOT__machine_timer__DOT__earlier_high_q",
                           "printer_core__DOT__thermal__DOT__sensors__DOT__seen_cycles_q"));
}

TEST_F(ReplayTest, follows_on_from_interval_to_interval) {
  for (std::size_t i = 1; i < intervals_.size(); ++i) {
    EXPECT_EQ(intervals_[i].start, intervals_[i - 1].end);
    EXPECT_EQ(intervals_[i].start->clock, intervals_[i - 1].end_clock);
  }
}

TEST_F(ReplayTest, finds_each_register_and_memory_outside_the_processor_that_differs) {
  const Interval& interval = busy_interval();
  ASSERT_EQ(words(model_.replay(interval)), "no difference");
  std::size_t place = 0;
  for (const replay::Register& chip_register : model_.registers()) {
    Snapshot end = *interval.end;
    // The last byte, so that of a memory the last element.
    place += chip_register.bytes;
    end.registers[place - 1] ^= 1;
    const std::optional<Difference> difference = model_.difference(end);
    if (!replay::ReplayModel::is_compared(chip_register.name)) {
      EXPECT_EQ(words(difference), "no difference") << chip_register.name;
    } else {
      EXPECT_THAT(words(difference), HasSubstr(chip_register.name));
    }
  }
  EXPECT_EQ(place, interval.end->registers.size());
}

TEST_F(ReplayTest, finds_each_register_of_the_processor_that_differs) {
  const Interval& interval = busy_interval();
  ASSERT_EQ(words(model_.replay(interval)), "no difference");
  using Processor = replay::ProcessorSnapshot;
  const std::map<std::string, std::uint32_t Processor::*> parts{
      {"pc", &Processor::program_counter},
      {"mstatus", &Processor::mstatus},
      {"mie", &Processor::mie},
      {"mtvec", &Processor::mtvec},
      {"mscratch", &Processor::mscratch},
      {"mepc", &Processor::mepc},
      {"mcause", &Processor::mcause},
      {"mtval", &Processor::mtval},
      {"mcountinhibit", &Processor::mcountinhibit}};
  for (const auto& [name, part] : parts) {
    Snapshot end = *interval.end;
    end.processor.*part ^= 8;
    EXPECT_EQ(words(model_.difference(end)), name);
  }
  for (std::size_t i = 1; i < 32; ++i) {
    Snapshot end = *interval.end;
    end.processor.registers[i] ^= 0x8000'0000;
    EXPECT_EQ(words(model_.difference(end)), "x" + std::to_string(i));
  }
  Snapshot end = *interval.end;
  end.processor.mcycle ^= std::uint64_t{1} << 40;
  EXPECT_EQ(words(model_.difference(end)), "mcycle");
  end = *interval.end;
  ++end.processor.minstret;
  EXPECT_EQ(words(model_.difference(end)), "minstret");
}

TEST_F(ReplayTest, finds_words_of_the_memory_and_counts_that_differ) {
  const Interval& interval = busy_interval();
  ASSERT_EQ(words(model_.replay(interval)), "no difference");
  for (const std::size_t word : {std::size_t{0}, interval.end->memory.size() - 1}) {
    Snapshot end = *interval.end;
    end.memory[word] ^= 0x100;
    EXPECT_THAT(words(model_.difference(end)), HasSubstr("memory at 0x8"));
  }
  Snapshot end = *interval.end;
  ++end.statistics.instructions;
  EXPECT_EQ(words(model_.difference(end)), "instructions");
  end = *interval.end;
  ++end.statistics.sleeping_clocks;
  EXPECT_EQ(words(model_.difference(end)), "clocks asleep");
}

TEST_F(ReplayTest, finds_the_clock_of_a_pin_that_changes_otherwise) {
  const Interval& good = busy_interval();
  const std::size_t middle = good.outputs.size() / 2;
  Interval late = good;
  ++late.outputs[middle].clock;
  std::optional<Difference> difference = model_.replay(late);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->clock, good.outputs[middle].clock);
  EXPECT_EQ(difference->interval, good.number);

  Interval missing = good;
  missing.outputs.erase(missing.outputs.begin() + static_cast<std::ptrdiff_t>(middle));
  difference = model_.replay(missing);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->clock, good.outputs[middle].clock);

  Interval wrong = good;
  wrong.outputs[middle].pins.word ^= sim::OutputPins::bit(sim::OutputPins::step_bit + 2);
  difference = model_.replay(wrong);
  EXPECT_EQ(words(difference), "pins step(2)");

  Interval one_more = good;
  one_more.outputs.push_back({good.end_clock, good.end->outputs});
  one_more.outputs.back().pins.word ^= sim::OutputPins::transmit_pin().word;
  EXPECT_EQ(words(model_.replay(one_more)), "pins transmit");
}

TEST_F(ReplayTest, depends_on_the_inputs_and_on_the_state_at_the_start) {
  const Interval& good = busy_interval();
  Interval other = good;
  for (replay::InputChange& change : other.inputs) change.pins.end_stops ^= 0xf0;
  EXPECT_NE(words(model_.replay(other)), "no difference");

  Interval changed = good;
  Snapshot start = *good.start;
  start.processor.mscratch ^= 1;
  changed.start = std::make_shared<const Snapshot>(start);
  EXPECT_EQ(words(model_.replay(changed)), "mscratch");
}

template <class Root>
std::vector<replay::Register> variables_of(Root& root) {
#define VARIABLE(name) replay::described(#name, root.name),
  return {
#include "chip_variables.inc"
  };
#undef VARIABLE
}

// Registers that have no meaning in a sleep: operands and results of units of the processor that
// are idle, the access before, the word that the last load has read, samples of mcycle and mtime.
bool has_no_meaning(std::string_view name) {
  if (!replay::ReplayModel::is_compared(name)) return true;
  constexpr std::string_view computer = "printer_core__DOT__with_processor_computing__DOT__";
  constexpr std::array idle{
      "cpu__DOT__execute__DOT__division__DOT__", "cpu__DOT__execute__DOT__multiplication__DOT__",
      "cpu__DOT__execute__DOT__data_access__DOT__",
      "cpu__DOT__machine_mode__DOT__control_status_registers__DOT__cycle_q", "ram__DOT__"};
  return name.starts_with(computer) && std::ranges::any_of(idle, [&](const char* part) {
           return name.substr(computer.size()).starts_with(part);
         });
}

// All registers and memories of the netlist, whether replay knows their names or not, have after an
// interval what they have in a netlist that is put into the snapshot at its end, from another past.
TEST_F(ReplayTest, puts_each_register_into_the_state_in_which_the_netlist_arrives) {
  OpenReplayModel other;
  for (const Interval& interval : intervals_) {
    if (!interval.end) continue;
    ASSERT_EQ(words(model_.replay(interval)), "no difference");
    other.put(*interval.end, interval.inputs.back().pins);
    const auto expected = variables_of(model_.root()), found = variables_of(other.root());
    ASSERT_GT(expected.size(), model_.registers().size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::string_view name = expected[i].name;
      if (std::ranges::equal(expected[i].contents(), found[i].contents())) continue;
      EXPECT_TRUE(has_no_meaning(name)) << name << " at the end of interval " << interval.number;
    }
  }
}

}  // namespace
