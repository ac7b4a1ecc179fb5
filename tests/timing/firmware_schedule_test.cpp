// SPDX-License-Identifier: Apache-2.0
// The main loop of the firmware's image meets all deadlines at the clocks of the pages; an image
// with a fault is refused, with its place; the figures of the pages are those of the image.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>

#include "directories.hpp"
#include "sim/processor/encode.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/timing/machine_schedule.hpp"

namespace timing {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;

namespace encode = processor::encode;

Program firmware() {
  Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
  program.memory_bytes = CHIP_MEMORY_BYTES;
  return program;
}

Schedule schedule_of(const Program& program) {
  return schedule_of(program, Costs{processor::TimingTable()}, CHIP_HAS_ZBB,
                     application::schedule_facts(false, false));
}

const Schedule& schedule() {
  static const Schedule once = schedule_of(firmware());
  return once;
}

std::vector<std::string> misses(std::uint32_t clock_hz, std::uint32_t baud) {
  std::vector<std::string> names;
  for (const Response& response : misses(schedule(), {clock_hz, baud})) {
    names.emplace_back(row_of(response.requirement).name);
  }
  return names;
}

TEST(FirmwareSchedule, has_every_bound) {
  EXPECT_THAT(missing_bounds(schedule()), IsEmpty());
  EXPECT_TRUE(schedule().load.is_whole());
}

TEST(FirmwareSchedule, misses_no_deadline) {
  for (const std::uint32_t clock_hz : table_clocks_hz) {
    EXPECT_THAT(misses(clock_hz, 250'000), IsEmpty()) << clock_hz;
    EXPECT_THAT(misses(clock_hz, 1'000'000), IsEmpty()) << clock_hz;
    if (clock_hz < 12'000'000) {
      continue;  // a bit takes 4 clocks
    }
    EXPECT_THAT(misses(clock_hz, 3'000'000), IsEmpty()) << clock_hz;
  }
}

TEST(FirmwareSchedule, has_a_lowest_clock_at_each_offered_rate) {
  for (const std::uint32_t baud : offered_baud_rates()) {
    const ClockRange range = clocks_that_hold(schedule().facts, schedule().load, baud);
    EXPECT_FALSE(range.is_empty());
    EXPECT_GT(range.lowest_hz, 3'000'000U);
    EXPECT_THAT(misses(range.lowest_hz, baud), IsEmpty());
    EXPECT_THAT(misses(range.lowest_hz - 1, baud), testing::Not(IsEmpty()));
  }
}

void replace(Program& program, Address place, std::span<const encode::Word> words) {
  Address at = place - program.first;
  for (const encode::Word word : words) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      program.bytes.at(at++) = static_cast<std::uint8_t>(word >> shift);
    }
  }
}

struct Fault {
  const char* name;
  std::function<void(Program&)> seed;
  const char* said;
};

TEST(FirmwareSchedule, of_an_image_with_a_fault_is_refused_with_its_place) {
  const auto in_parser = [](encode::Word word) {
    return [word](Program& program) {
      replace(program, program.find("gcode::parse").at(0), std::array{word});
    };
  };
  const Fault faults[] = {
      {"no loop is declared", [](Program& program) { program.markers.clear(); },
       "a loop has no bound: declare LoopBound"},
      {"no call by pointer is declared", [](Program& program) { program.call_tables.clear(); },
       "declare the table of its pointer"},
      {"an endless loop", in_parser(encode::jump_and_link(0, 0)), "a loop has no end"},
      {"recursion", in_parser(encode::jump_and_link(1, 0)),
       "the function calls itself, or others that call it: write it as a loop"},
  };
  for (const Fault& fault : faults) {
    Program program = firmware();
    fault.seed(program);
    const Verdict verdict = verdict_on(schedule_of(program), {}, {}, "machine.toml");
    EXPECT_TRUE(verdict.is_refused) << fault.name;
    EXPECT_THAT(verdict.text, HasSubstr("\"the pass over all tasks\" has no bound"));
    EXPECT_THAT(verdict.text, HasSubstr(fault.said)) << fault.name;
    EXPECT_THAT(verdict.text, ContainsRegex("firmware/[a-z_/]+[.][chp]+:[0-9]+: in "))
        << fault.name;
  }
}

TEST(FirmwareSchedule, of_an_image_that_enables_interrupts_is_refused) {
  constexpr std::uint32_t set_bits = 6, status_register = 0x300;  // csrrsi
  Program program = firmware();
  replace(program, program.find("gcode::parse").at(0),
          std::array{encode::csr(set_bits, 0, status_register, 8)});
  try {
    schedule_of(program);
    ADD_FAILURE() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("in gcode::parse: interrupts are enabled"));
    EXPECT_THAT(error.what(), HasSubstr("firmware/gcode/"));
  }
}

TEST(FirmwareSchedule, is_that_of_the_figures) {
  const auto figures =
      nlohmann::json::parse(std::ifstream(PROJECT_DIRECTORY "/tools/figures/figures.json"));
  const auto& tasks = figures.at("tasks").at("values");
  for (const TaskRow& row : schedule().rows) {
    std::string key = row.name.substr(0, row.name.find_first_of(" :"));
    if (key == "the") key = "pass";
    EXPECT_EQ(tasks.at(key + "_bound"), row.bound.value()) << row.name;
  }
  EXPECT_EQ(figures.at("schedule").at("values").at("lowest_hz"),
            clocks_that_hold(schedule().facts, schedule().load, 250'000).lowest_hz);
}

}  // namespace
}  // namespace timing
