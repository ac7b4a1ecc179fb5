// SPDX-License-Identifier: Apache-2.0
// The table of times, applied to one instruction after the other.
#include "tests/processor/time_model.hpp"

#include "tests/processor/timed_instruction.hpp"

namespace processor {
namespace {

// Parts of the clocks of an interrupt: it is taken in the clock after the request at the earliest;
// in the last clock the handler's first instruction retires.
constexpr unsigned clocks_to_take = 2, clocks_of_first_instruction = 1;

}  // namespace

std::uint64_t TimeModel::first_active(std::uint64_t from, std::uint64_t to,
                                      std::uint32_t enabled) const {
  for (std::uint64_t clock = from; clock <= to && clock < requests_.size() + 2; ++clock) {
    if (clock >= 2 && (requests_[clock - 2] & enabled) != 0) return clock;
  }
  return 0;
}

std::optional<TimeModel::Prediction> TimeModel::next(const InstructionSetModel& model) const {
  if (!begun_) return std::nullopt;
  const auto timed = timed_instruction(model, Chip::has_zbb);
  const bool waits = timed && late_register_ != 0 &&
                     (timed->first == late_register_ || timed->second == late_register_);
  const std::uint64_t begins = clock_ + behind_ + 1;
  const std::uint64_t executes = begins + (waits ? table_.at("load-use hazard") : 0);
  std::uint64_t ends = executes;
  std::uint64_t last_open = executes;
  if (timed && timed->on_bus) {
    ends += table_.at(timed->row) - 2 + bus_wait_;
  } else if (timed && timed->sleeps) {
    last_open = begins - 1;
    ends = first_active(begins, requests_.size() + 1, model.enabled_interrupts());
  } else if (timed && timed->row == std::string("division")) {
    ends += table_.at("division") - 1;
    last_open = ends;
  }
  const std::uint64_t taken =
      model.interrupts_allowed()
          ? first_active(clock_ + closed_ + 1, last_open, model.enabled_interrupts())
          : 0;
  if (taken != 0) return Prediction{.clock = taken, .interrupt = true};
  if (ends == 0) return std::nullopt;
  return Prediction{.clock = ends};
}

unsigned TimeModel::clocks_behind(const Retirement& event, const InstructionSetModel& model) const {
  if (event.interrupt) return table_.at("interrupt") - clocks_to_take - clocks_of_first_instruction;
  const auto timed = timed_instruction(model, Chip::has_zbb);
  if (event.trap && timed && timed->on_bus) {
    return table_.at("refused access") - table_.at(timed->row);
  }
  if (event.trap) return table_.at("exception") - 1;
  const bool ends_in_its_last_clock = timed->on_bus || timed->row == std::string("division");
  return ends_in_its_last_clock ? 0 : table_.at(timed->row) - 1;
}

void TimeModel::note(const Retirement& event, const InstructionSetModel& model_before) {
  const auto timed = timed_instruction(model_before, Chip::has_zbb);
  begun_ = true;
  clock_ = event.clock;
  behind_ = clocks_behind(event, model_before);
  late_register_ = !event.trap && timed->late ? event.destination : 0;
  const bool returns = !event.trap && timed->row == std::string("mret");
  closed_ = returns ? table_.at("interrupt requested with mret") - table_.at("interrupt") : 0;
}

}  // namespace processor
