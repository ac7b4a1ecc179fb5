// SPDX-License-Identifier: Apache-2.0
// Follows the netlist with the model, as a simulation does it.
#include "tests/processor/model_lockstep.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <random>

#include "sim/processor/processor_model.hpp"
#include "tests/processor/chip.hpp"

namespace processor {
namespace {

// The netlist's reset lasts for two clocks.
constexpr Clock released = 3;

class Run {
 public:
  Run(const std::vector<std::uint8_t>& image, const ModelLockstepSettings& settings)
      : settings_(settings),
        chip_(image),
        model_(Chip::memory_size, Chip::has_zbb),
        random_(settings.seed) {
    chip_.set_bus_wait(settings.bus_wait);
    for (std::size_t i = 0; i < image.size(); i += 4) {
      Word word = 0;
      for (std::size_t byte = 0; byte < std::min<std::size_t>(4, image.size() - i); ++byte) {
        word |= Word{image[i + byte]} << (8 * byte);
      }
      model_.write_memory(Chip::memory_base + static_cast<Word>(i), word);
    }
    model_.reset(released);
  }

  ModelLockstep result() {
    while (chip_.clocks() < settings_.clocks && result_.difference.empty()) clock();
    if (result_.difference.empty()) compare_memory();
    result_.interrupted = interrupted_;
    result_.behind = behind_;
    return result_;
  }

 private:
  using Word = std::uint32_t;

  void request() {
    if (settings_.seed == 0) return;
    if (pause_ != 0) {
      --pause_;
      return;
    }
    pause_ = static_cast<unsigned>(random_()) % settings_.longest_pause;
    const Word two = 1U << random_() % 32 | 1U << random_() % 32;
    // A line may fall again before it has been sampled.
    const Word lines = chip_.device().interrupts() == 0 || random_() % 4 == 0 ? two : 0;
    if (lines == 0 && random_() % 4 != 0) return;
    chip_.device().set_interrupts(lines & TestDevice::interrupt_mask);
  }

  void clock() {
    request();
    const Clock now = chip_.clocks();
    // After edge `now` the lines are as the device has them.
    model_.set_interrupts(now, chip_.device().interrupts());
    if (model_.complete() <= now) model_.mark();
    if (!model_.accesses()) {
      const Clock lead = settings_.longest_lead == 1 ? 1 : 1 + random_() % settings_.longest_lead;
      model_.run(now + lead);
    }
    const Word data = answer(now);
    const auto event = chip_.clock();
    note_answer(now, data);
    judge(event);
  }

  // What a load on the bus is answered with in this clock, as the chip's own device would.
  Word answer(Clock now) {
    if (!model_.accesses() || now + 1 != response_clock()) return 0;
    return chip_.device().read(model_.access().address & ~3U).value_or(0);
  }

  Clock response_clock() const { return model_.access_clock() + 1 + settings_.bus_wait; }

  void note_answer(Clock now, Word data) {
    if (!model_.accesses() || now + 1 != response_clock()) return;
    // A store to the register of requests acts in the clock of the response.
    model_.set_interrupts(now, chip_.device().interrupts());
    const BusAccess& access = model_.access();
    bool is_refused = !chip_.device().read(access.address & ~3U);
    // The one register that takes nothing but words.
    if (access.write && (access.address & ~3U) == TestDevice::interrupt_register) {
      is_refused = access.lanes != 0xf;
    }
    ++result_.accesses;
    model_.complete_access(now + 1, is_refused, data);
  }

  // What the netlist has done so far.
  void note(const std::optional<Retirement>& event) {
    if (chip_.sleeping()) ++netlist_.sleeping_clocks;
    if (!event) return;
    note_interrupt(*event);
    ++(event->trap ? netlist_.traps : netlist_.instructions);
    if (event->trap) {
      trap_address_ = event->address;
    } else if (event->destination != 0) {
      registers_[event->destination] = event->value;
    }
  }

  void note_interrupt(const Retirement& event) {
    if (event.interrupt) {
      const auto operation = operation_at(event.address);
      if (operation) ++interrupted_[*operation];
      if (last_operation_) ++behind_[*last_operation_];
    }
    last_operation_.reset();
    if (!event.trap) {
      last_operation_ = decode(event.instruction, event.address, Chip::has_zbb).operation;
    }
  }

  // Nothing outside the memory.
  std::optional<Operation> operation_at(Word address) const {
    const Word place = address - Chip::memory_base;
    if (place >= Chip::memory_size - 4) return std::nullopt;
    const Word low = chip_.word(address & ~3U), high = chip_.word((address & ~3U) + 4);
    const Word word = (address & 2) == 0 ? low : low >> 16 | high << 16;
    return decode(word, address, Chip::has_zbb).operation;
  }

  // With a lead the model is brought back to the present edge now and then only: otherwise it is
  // where it is when a line changes.
  void judge(const std::optional<Retirement>& event) {
    note(event);
    if (settings_.longest_lead > 1 && random_() % 16 != 0) return;
    const Clock now = chip_.clocks();
    model_.bring_to(now);
    const MachineState& state = model_.state();
    if (model_.instructions() != netlist_.instructions) return differs(event, "other instructions");
    if (model_.traps() != netlist_.traps) return differs(event, "other traps");
    if (event && event->trap && state.exception_address != trap_address_) {
      return differs(event, "a trap elsewhere");
    }
    if (!std::equal(registers_.begin(), registers_.end(), state.registers.begin())) {
      return differs(event, "another value");
    }
    if (model_.sleeping_clocks(now) != netlist_.sleeping_clocks) {
      return differs(event, "another sleep");
    }
    netlist_.accesses = result_.accesses;
    result_ = netlist_;
  }

  void differs(const std::optional<Retirement>& event, const char* what) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "clock %llu: the netlist has %s at %08x (%08x) x%u = %08x, the model %s; it goes "
                  "on at %08x",
                  static_cast<unsigned long long>(chip_.clocks()),
                  !event        ? "nothing"
                  : event->trap ? "a trap"
                                : "an instruction",
                  event ? event->address : 0, event ? event->instruction : 0,
                  event ? event->destination : 0, event ? event->value : 0, what,
                  model_.state().program_counter);
    result_.difference = text;
  }

  void compare_memory() {
    model_.bring_to(chip_.clocks());
    const auto memory = chip_.memory();
    for (std::size_t i = 0; i < memory.size(); i += 4) {
      const Word address = Chip::memory_base + static_cast<Word>(i);
      if (model_.read_memory(address) != chip_.word(address)) {
        result_.difference = "the memories differ at " + std::to_string(address);
        return;
      }
    }
  }

  const ModelLockstepSettings settings_;
  Chip chip_;
  ProcessorModel model_;
  std::mt19937 random_;
  ModelLockstep result_;
  ModelLockstep netlist_;
  std::array<Word, no_register> registers_{};
  std::map<Operation, std::uint64_t> interrupted_, behind_;
  std::optional<Operation> last_operation_;
  Word trap_address_ = 0;
  unsigned pause_ = 0;
};

}  // namespace

ModelLockstep run_model_lockstep(const std::vector<std::uint8_t>& image,
                                 const ModelLockstepSettings& settings) {
  return Run(image, settings).result();
}

}  // namespace processor
