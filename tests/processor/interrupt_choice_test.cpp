// SPDX-License-Identifier: Apache-2.0
// Which of several interrupts is taken, and where it leads: every pair of the 18, direct and by
// vectors, and any sets of those that are there and those that are enabled.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include "tests/processor/chip.hpp"
#include "tests/processor/program_builder.hpp"

namespace processor {
namespace {

using encode::Word;

// In the order of the manual (external before timer), then this processor's own by their numbers.
constexpr std::array<Word, 18> by_rank{11, 7,  16, 17, 18, 19, 20, 21, 22,
                                       23, 24, 25, 26, 27, 28, 29, 30, 31};
constexpr Word vectors = Chip::memory_base + 0x100;

struct Settings {
  Word enabled = 0xFFFFFFFF;  // mie
  Word requested = 0;
  bool vectored = false;
  bool allowed = true;  // mstatus.MIE
};

struct Taken {
  Word cause = 0;  // mcause
  Word handler = 0;  // the address of its first instruction

  bool operator==(const Taken&) const = default;
};

std::vector<std::uint8_t> waiting_program(const Settings& settings) {
  constexpr Word pointer = 5, mask = 6, cause = 18;
  ProgramBuilder program;
  program.add(encode::load_upper(pointer, Chip::memory_base));
  program.add(encode::add_immediate(
      pointer, pointer,
      static_cast<std::int32_t>(vectors - Chip::memory_base) + (settings.vectored ? 1 : 0)));
  program.add(encode::csr(1, 0, 0x305, pointer));
  program.add(encode::load_upper(mask, settings.enabled + 0x800));
  program.add(
      encode::add_immediate(mask, mask, static_cast<std::int32_t>(settings.enabled << 20) >> 20));
  program.add(encode::csr(1, 0, 0x304, mask));
  program.add(encode::csr(5, 0, 0x300, settings.allowed ? 8 : 0));
  program.add(encode::jump_and_link(0, 0));
  while (program.bytes() < vectors - Chip::memory_base) program.add(encode::nop());
  for (unsigned vector = 0; vector < 32; ++vector) program.add(encode::csr(2, cause, 0x342, 0));
  return program.image();
}

// Nothing where none is taken while the processor waits.
std::optional<Taken> first_taken(const Settings& settings) {
  constexpr unsigned instructions_before = 12, instructions_to_watch = 40;
  Chip chip(waiting_program(settings));
  for (unsigned i = 0; i < instructions_before; ++i) chip.next_retirement();
  chip.device().set_interrupts(settings.requested);
  for (unsigned i = 0; i < instructions_to_watch; ++i) {
    const auto event = chip.next_retirement();
    if (!event) break;
    if (event->address >= vectors) return Taken{event->value, event->address};
  }
  return std::nullopt;
}

std::optional<Taken> expected(const Settings& settings) {
  const Word due = settings.allowed ? settings.enabled & settings.requested : 0;
  const auto* const first =
      std::ranges::find_if(by_rank, [&](Word interrupt) { return (due >> interrupt & 1) != 0; });
  if (first == by_rank.end()) return std::nullopt;
  return Taken{1u << 31 | *first, vectors + (settings.vectored ? 4 * *first : 0)};
}

void check(const Settings& settings) {
  ASSERT_EQ(first_taken(settings), expected(settings))
      << std::hex << "requested " << settings.requested << ", enabled " << settings.enabled
      << (settings.vectored ? ", vectored" : ", direct")
      << (settings.allowed ? "" : ", not allowed");
}

TEST(InterruptChoice, of_every_pair_is_by_rank_and_leads_to_its_handler) {
  for (const bool vectored : {false, true}) {
    for (const Word one : by_rank) {
      for (const Word other : by_rank) {
        check({.requested = 1u << one | 1u << other, .vectored = vectored});
        if (HasFailure()) return;
      }
    }
  }
}

TEST(InterruptChoice, is_among_those_that_are_enabled) {
  for (const Word one : by_rank) {
    check({.enabled = 1u << one, .requested = TestDevice::interrupt_mask});
    check({.enabled = ~(1u << one), .requested = 1u << one});
    check({.requested = 1u << one, .allowed = false});
  }
  std::mt19937 random(1);
  for (unsigned i = 0; i < 500 && !HasFailure(); ++i) {
    const Word few = static_cast<Word>(random() & random());
    check({.enabled = static_cast<Word>(random() & random()),
           .requested = few & TestDevice::interrupt_mask,
           .vectored = random() % 2 == 0,
           .allowed = random() % 8 != 0});
  }
}

}  // namespace
}  // namespace processor
