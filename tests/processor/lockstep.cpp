// SPDX-License-Identifier: Apache-2.0
// The chip and the instruction-set model side by side.
#include "tests/processor/lockstep.hpp"

#include <cstdio>
#include <random>

#include "sim/processor/encode.hpp"

namespace processor {
namespace {

template <class Event>
std::string describe(const Event& event) {
  char text[120];
  std::snprintf(text, sizeof text, "%s at %08x (%08x) x%u = %08x",
                event.trap ? "trap" : "completed", event.address, event.instruction,
                event.destination, event.value);
  return text;
}

// An interrupt must be taken at once after an instruction that allows it, and within three
// instructions where the request itself is new.
class InterruptWatch {
 public:
  bool is_late(const InstructionSetModel& model) const {
    return model.interrupt_due() && unchanged_for_ >= 3;
  }
  void note(std::uint32_t requests) {
    unchanged_for_ = requests == requests_ ? unchanged_for_ + 1 : 0;
    requests_ = requests;
  }

 private:
  std::uint32_t requests_ = 0;
  unsigned unchanged_for_ = 0;
};

}  // namespace

bool reads_cycle(std::uint32_t instruction) {
  const std::uint32_t address = instruction >> 20;
  return (instruction & 0x7F) == 0x73 && (instruction >> 12 & 3) != 0 &&
         (address == 0xB00 || address == 0xB80 || address == 0xC00 || address == 0xC80);
}

LockstepResult run_lockstep(const std::vector<std::uint8_t>& image,
                            const LockstepSettings& settings) {
  Chip chip(image);
  chip.set_bus_wait(settings.bus_wait);
  InstructionSetModel model(image, Chip::memory_size, Chip::has_zbb);
  LockstepResult result;
  std::mt19937 random(settings.interrupt_seed);
  InterruptWatch watch;

  while (result.instructions + result.traps < settings.max_instructions) {
    auto event = chip.next_retirement();
    if (!event && chip.sleeping() && settings.wake_request != 0 &&
        chip.device().read(TestDevice::base) == settings.wake_word) {
      chip.device().set_interrupts(settings.wake_request);
      model.device().set_interrupts(settings.wake_request);
      event = chip.next_retirement();
    }
    if (!event) {
      result.difference = "the chip does nothing any more";
      break;
    }
    // The chip decides when an interrupt is taken; the model checks that it was due, and which one.
    auto interrupt = std::optional<Step>();
    if (event->interrupt) {
      interrupt = model.take_interrupt();
      if (!interrupt) {
        result.difference = "an interrupt that was not due: " + describe(*event);
        break;
      }
    }
    watch.note(chip.device().interrupts());
    if (!event->interrupt && event->instruction != encode::wait_for_interrupt() &&
        watch.is_late(model)) {
      result.difference = "an interrupt that was not taken: " + describe(*event);
      break;
    }
    Step expected = interrupt ? *interrupt : model.step();
    if (!event->trap && reads_cycle(event->instruction)) {
      model.set_register(event->destination, event->value);
      expected.value = event->value;
    }
    const bool same = event->trap == expected.trap && event->address == expected.address &&
                      (event->trap || (event->instruction == expected.instruction &&
                                       event->destination == expected.destination &&
                                       event->value == expected.value));
    if (!same) {
      result.difference = "after " + std::to_string(result.instructions) + " instructions: chip " +
                          describe(*event) + ", model " + describe(expected);
      break;
    }
    ++(event->trap ? result.traps : result.instructions);
    if (interrupt) ++result.interrupts;
    // Where one is due already, a second could come before or after the chip's choice.
    if (settings.interrupt_seed != 0 && random() % 16 == 0 && !model.interrupt_due()) {
      const std::uint32_t request = 1u << random() % 32;
      chip.device().set_interrupts(chip.device().interrupts() |
                                   (request & TestDevice::interrupt_mask));
      model.device().set_interrupts(chip.device().interrupts());
      watch.note(chip.device().interrupts());
    }
    if (settings.tohost_address != 0) {
      result.tohost = chip.word(settings.tohost_address);
      if (result.tohost != 0) break;
    }
  }
  result.clocks = chip.clocks();
  if (result.difference.empty() && chip.memory() != model.memory()) {
    result.difference = "the memories differ at the end";
  }
  return result;
}

}  // namespace processor
