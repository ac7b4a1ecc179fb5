// SPDX-License-Identifier: Apache-2.0
// The chip, the instruction-set model and the table of times side by side.
#include "tests/processor/timed_run.hpp"

#include <cstdio>
#include <random>

#include "tests/processor/lockstep.hpp"
#include "tests/processor/time_model.hpp"
#include "tests/processor/timed_instruction.hpp"

namespace processor {
namespace {

constexpr unsigned longest_silence = 100;

std::string describe(const Retirement& event,
                     const std::optional<TimeModel::Prediction>& expected) {
  char text[160];
  std::snprintf(text, sizeof text, "%s at %08x (%08x) in clock %llu instead of %s %llu",
                event.interrupt ? "interrupt"
                : event.trap    ? "exception"
                                : "instruction",
                event.address, event.instruction, static_cast<unsigned long long>(event.clock),
                !expected             ? "none"
                : expected->interrupt ? "interrupt"
                                      : "instruction",
                static_cast<unsigned long long>(expected ? expected->clock : 0));
  return text;
}

class Run {
 public:
  Run(const std::vector<std::uint8_t>& image, const TimedRunSettings& settings)
      : settings_(settings),
        chip_(image),
        model_(image, Chip::memory_size, Chip::has_zbb),
        times_(table_, settings.bus_wait),
        random_(settings.seed) {
    chip_.set_bus_wait(settings.bus_wait);
    for (std::uint64_t clock = 0; clock < chip_.clocks(); ++clock) times_.note_requests(0);
  }

  TimedRun result() {
    while (chip_.clocks() < settings_.clocks && result_.difference.empty()) {
      request();
      const auto event = chip_.clock();
      requests_before_ = requests_;
      requests_ = chip_.device().interrupts();
      times_.note_requests(requests_);
      event ? judge(*event) : judge_silence();
    }
    return result_;
  }

 private:
  void request() {
    if (settings_.seed == 0 || chip_.device().interrupts() != 0) return;
    if (pause_ != 0) {
      --pause_;
      return;
    }
    pause_ = static_cast<unsigned>(random_()) % settings_.longest_pause;
    const std::uint32_t two = 1u << random_() % 32 | 1u << random_() % 32;
    chip_.device().set_interrupts(two & TestDevice::interrupt_mask);
  }

  void judge_silence() {
    if (++silent_for_ < longest_silence) return;
    const auto expected = times_.next(model_);
    if (expected && expected->clock <= chip_.clocks()) {
      result_.difference = "no event, though one was expected in clock " +
                           std::to_string(expected->clock) + ", and it is clock " +
                           std::to_string(chip_.clocks());
    }
    silent_for_ = 0;
  }

  void judge(const Retirement& event) {
    const auto expected = times_.next(model_);
    const bool is_right =
        expected && expected->clock == event.clock && expected->interrupt == event.interrupt;
    if (begun_ && !is_right) {
      result_.difference = describe(event, expected) + last_;
      return;
    }
    begun_ = true;
    silent_for_ = 0;
    const auto timed = timed_instruction(model_, Chip::has_zbb);
    const std::string row = event.trap && !event.interrupt ? "exception" : timed ? timed->row : "";
    if (event.interrupt) {
      ++result_.interrupts;
      ++result_.interrupted[row];
      ++result_.behind[row_before_];
    }
    row_before_ = row;
    times_.note(event, model_);
    follow(event);
    last_ = "; before it " + describe(event, expected);
  }

  void follow(const Retirement& event) {
    model_.device().set_interrupts(event.interrupt ? requests_before_ : requests_);
    const auto step = event.interrupt ? model_.take_interrupt() : model_.step();
    ++result_.instructions;
    if (step && !event.trap && reads_cycle(event.instruction)) {
      model_.set_register(event.destination, event.value);
    }
    if (!step || step->trap != event.trap || step->address != event.address) {
      result_.difference = "the model does something else: " + describe(event, std::nullopt);
    }
  }

  const TimedRunSettings settings_;
  const TimingTable table_;
  Chip chip_;
  InstructionSetModel model_;
  TimeModel times_;
  std::mt19937 random_;
  TimedRun result_;
  std::uint32_t requests_ = 0, requests_before_ = 0;
  unsigned pause_ = 0, silent_for_ = 0;
  bool begun_ = false;
  std::string row_before_, last_;
};

}  // namespace

TimedRun run_timed(const std::vector<std::uint8_t>& image, const TimedRunSettings& settings) {
  return Run(image, settings).result();
}

}  // namespace processor
