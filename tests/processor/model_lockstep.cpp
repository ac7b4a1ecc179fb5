// SPDX-License-Identifier: Apache-2.0
// Follows the netlist with the model, as a simulation does it.
#include "tests/processor/model_lockstep.hpp"

#include <algorithm>
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
    // A line may fall again before anybody has seen it.
    const Word lines = chip_.device().interrupts() == 0 || random_() % 4 == 0 ? two : 0;
    if (lines == 0 && random_() % 4 != 0) return;
    chip_.device().set_interrupts(lines & TestDevice::interrupt_mask);
  }

  void clock() {
    request();
    const Clock now = chip_.clocks();
    // Behind edge `now` the lines are as the device has them.
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

  // Looks back to the present edge, and then ahead again.
  void judge(const std::optional<Retirement>& event) {
    const Clock now = chip_.clocks();
    model_.bring_to(now);
    const bool retired = model_.instructions() != instructions_, trapped = model_.traps() != traps_;
    instructions_ = model_.instructions();
    traps_ = model_.traps();
    const MachineState& state = model_.state();
    const bool expects_retired = event && !event->trap, expects_trap = event && event->trap;
    if (now > released + 1 && (retired != expects_retired || trapped != expects_trap)) {
      return differs(event, retired ? "an instruction" : trapped ? "a trap" : "nothing");
    }
    if (expects_trap && (state.exception_address != event->address ||
                         (state.trap_cause >> 31 != 0) != event->interrupt)) {
      return differs(event, "another trap");
    }
    if (expects_retired && event->destination != 0 &&
        state.registers[event->destination] != event->value) {
      return differs(event, "another value");
    }
    if (chip_.sleeping()) ++sleeping_;
    if (model_.sleeping_clocks(now) != sleeping_) return differs(event, "another sleep");
    result_.instructions = instructions_;
    result_.traps = traps_;
    result_.sleeping_clocks = sleeping_;
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
  std::uint64_t instructions_ = 0, traps_ = 0, sleeping_ = 0;
  unsigned pause_ = 0;
};

}  // namespace

ModelLockstep run_model_lockstep(const std::vector<std::uint8_t>& image,
                                 const ModelLockstepSettings& settings) {
  return Run(image, settings).result();
}

}  // namespace processor
