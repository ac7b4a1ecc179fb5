// SPDX-License-Identifier: Apache-2.0
// Random programs do on the chip what they do in QEMU, register by register,
// instruction by instruction.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "tests/processor/chip.hpp"
#include "tests/processor/qemu_machine.hpp"
#include "tests/processor/random_program.hpp"

namespace processor {
namespace {

struct Count {
  std::uint64_t instructions = 0;
  std::uint64_t traps = 0;
  std::uint64_t compressed = 0;
};

std::string describe(const Retirement& event, std::uint64_t count) {
  std::ostringstream text;
  text << std::hex << "at " << event.address << " instruction " << event.instruction << std::dec
       << ", number " << count;
  return text.str();
}

// The chip's registers as its retired instructions give them.
class Registers {
 public:
  void note(const Retirement& event) {
    if (!event.trap && event.destination != 0) values_.at(event.destination) = event.value;
  }
  // Which differ; empty where none does.
  std::string difference(const QemuRecord& state) const {
    std::ostringstream text;
    for (std::size_t index = 0; index < values_.size(); ++index) {
      if (values_.at(index) == state.registers.at(index)) continue;
      text << "x" << index << std::hex << " is " << values_.at(index) << ", QEMU's is "
           << state.registers.at(index) << std::dec << "; ";
    }
    return text.str();
  }
  // After the chip's reset they hold anything: those of QEMU's loader are taken over.
  void start_from(const QemuRecord& state) { values_ = state.registers; }

 private:
  std::array<std::uint32_t, 32> values_{};
};

// Both start with registers of their own, so all are written before they are read.
void run_with_qemu(std::uint32_t seed, const RandomProgramSettings& settings, Count& count) {
  const auto image = random_program(seed, settings);
  Chip chip(image);
  QemuMachine qemu(image, Chip::has_zbb);
  Registers registers;
  auto state = qemu.next();
  ASSERT_TRUE(state.has_value()) << "QEMU does not run";
  registers.start_from(*state);
  while (chip.word(random_program_tohost) == 0) {
    const auto event = chip.next_retirement();
    ASSERT_TRUE(event.has_value()) << "the chip does nothing any more";
    ASSERT_EQ(event->address, state->program_counter) << describe(*event, count.instructions);
    state = qemu.next();
    ASSERT_TRUE(state.has_value()) << "QEMU has ended";
    registers.note(*event);
    ASSERT_EQ(registers.difference(*state), "") << describe(*event, count.instructions);
    if (event->trap) {
      // Cause and value come into registers, where the handler reads them.
      ASSERT_EQ(state->program_counter, state->mtvec) << describe(*event, count.instructions);
      ASSERT_EQ(state->mepc, event->address) << describe(*event, count.instructions);
      ++count.traps;
      continue;
    }
    ++count.instructions;
    if ((event->instruction & 3) != 3) ++count.compressed;
  }
}

// How many instructions at least: STEPFABRIC_QEMU_INSTRUCTIONS, by default what takes some minutes.
std::uint64_t wanted_instructions() {
  const char* const text = std::getenv("STEPFABRIC_QEMU_INSTRUCTIONS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 10'000'000;
}

TEST(Qemu, does_the_same_as_the_chip) {
  Count count;
  for (std::uint32_t seed = 1; count.instructions < wanted_instructions(); ++seed) {
    const RandomProgramSettings settings{.length = 9000,
                                         .wild_per_mille = seed % 4 == 0 ? 300u : 30u,
                                         .interrupts = false,
                                         .portable = true,
                                         .zbb = Chip::has_zbb,
                                         .passes = 25};
    run_with_qemu(seed, settings, count);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
  }
  // The programs must have exercised enough.
  EXPECT_GT(count.traps, count.instructions / 100);
  EXPECT_GT(count.compressed, count.instructions / 5);
  std::printf("%llu instructions, %llu of them compressed, %llu traps\n",
              static_cast<unsigned long long>(count.instructions),
              static_cast<unsigned long long>(count.compressed),
              static_cast<unsigned long long>(count.traps));
}

}  // namespace
}  // namespace processor
