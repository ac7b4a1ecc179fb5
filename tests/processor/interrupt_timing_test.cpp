// SPDX-License-Identifier: Apache-2.0
// The longest and the shortest ways from a request to the handler, clock by clock, are those of the
// table in rtl/processor/timing.md.
#include <gtest/gtest.h>

#include <set>

#include "sim/processor/timing_table.hpp"
#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/timing_kinds.hpp"

namespace processor {
namespace {

using encode::Word;
using namespace timed;
namespace compressed = encode::compressed;

constexpr Word first_tested = Chip::memory_base + program_bytes;

std::uint64_t clock_at(Chip& chip, Word address) {
  while (const auto event = chip.next_retirement()) {
    if (!event->trap && event->address == address) return event->clock;
  }
  return 0;
}

// From the clock in which the request is there, so many clocks after the completion of the first
// instruction, to the completion of the handler's first.
unsigned latency(const std::vector<Word>& tested, Word handler, unsigned delay) {
  Chip chip(place(tested, false, handler).image);
  clock_at(chip, first_tested);
  for (unsigned count = 0; count < delay; ++count) chip.clock();
  const std::uint64_t begin = chip.clocks();
  chip.device().set_interrupts(1u << 31);
  return static_cast<unsigned>(clock_at(chip, handler) - begin);
}

// The same in a loop around the instruction.
unsigned latency_in_loop(Word running, unsigned delay) {
  std::vector<Word> tested{running, compressed::nop(), compressed::nop()};
  if ((running & 3) != 3) tested.push_back(compressed::nop());
  tested.push_back(encode::jump_and_link(0, -8));
  return latency(tested, first_tested + 12, delay);
}

TEST(InterruptTiming, is_the_same_whatever_is_executed) {
  const TimingTable table;
  const unsigned clocks = table.at("interrupt");
  const unsigned bus_wait = table.at("interrupt during a peripheral access, at most in addition");
  for (const auto& kind : kinds_of_instructions()) {
    if (kind.placed) continue;
    const std::string row = kind.row;
    std::set<unsigned> all;
    for (unsigned delay = 0; delay < 40; ++delay) all.insert(latency_in_loop(kind.word, delay));
    EXPECT_EQ(*all.begin(), clocks) << row;
    const bool on_bus = row.find("peripheral") != std::string::npos;
    EXPECT_EQ(*all.rbegin(), clocks + (on_bus ? bus_wait : 0)) << row;
  }
}

TEST(InterruptTiming, is_longer_where_it_is_requested_with_a_return) {
  const TimingTable table;
  const std::vector<Word> tested{encode::add_immediate(5, 0, 0x80),  // MPIE
                                 encode::csr(2, 0, 0x300, 5),
                                 encode::add_upper_to_pc(place_address, 0),
                                 encode::add_immediate(place_address, place_address, 16),
                                 encode::csr(1, 0, 0x341, place_address),
                                 encode::trap_return(),
                                 encode::nop(),
                                 encode::nop(),
                                 encode::nop()};
  const Word handler = first_tested + 4 * static_cast<Word>(tested.size());
  // The return is executed in the fifth clock after the first instruction.
  for (unsigned delay = 0; delay < 10; ++delay) {
    EXPECT_EQ(latency(tested, handler, delay),
              table.at(delay == 4 ? "interrupt requested with mret" : "interrupt"))
        << delay;
  }
}

TEST(InterruptTiming, is_longer_by_each_wfi_before_it) {
  const TimingTable table;
  const unsigned more = table.at("interrupt after wfi, in addition");
  for (unsigned count = 1; count <= 6; ++count) {
    std::vector<Word> tested{encode::nop()};
    tested.insert(tested.end(), count, encode::wait_for_interrupt());
    tested.insert(tested.end(), 3, encode::nop());
    const Word handler = first_tested + 4 * static_cast<Word>(tested.size());
    for (unsigned delay = 4; delay < 12; ++delay) {
      EXPECT_EQ(latency(tested, handler, delay), table.at("interrupt") + count * more)
          << count << " times wfi, " << delay;
    }
  }
}

TEST(InterruptTiming, sleep_ends_in_its_clocks) {
  const TimingTable table;
  // mie lets it through, mstatus does not.
  const std::vector<Word> tested{encode::csr(5, 0, 0x304, 0),  encode::load_upper(5, 1u << 31),
                                 encode::csr(1, 0, 0x304, 5),  encode::wait_for_interrupt(),
                                 encode::wait_for_interrupt(), encode::wait_for_interrupt()};
  for (unsigned delay = 0; delay < 12; ++delay) {
    Chip chip(place(tested, false).image);
    clock_at(chip, first_tested + 8);
    for (unsigned count = 0; count < delay; ++count) chip.clock();
    const std::uint64_t begin = chip.clocks();
    EXPECT_EQ(chip.sleeping(), true);
    chip.device().set_interrupts(1u << 31);
    const std::uint64_t woken = clock_at(chip, first_tested + 12);
    EXPECT_EQ(woken - begin, table.at("wake-up from wfi")) << delay;
    EXPECT_EQ(clock_at(chip, first_tested + 20) - woken, 2 * table.at("wfi")) << delay;
  }
}

}  // namespace
}  // namespace processor
