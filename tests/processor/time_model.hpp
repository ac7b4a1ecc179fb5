// SPDX-License-Identifier: Apache-2.0
// Predicts the clock in which each instruction retires or traps and each interrupt is taken, from
// nothing but the table of times, the preceding instructions and the requests.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/processor/chip.hpp"
#include "tests/processor/instruction_set_model.hpp"
#include "tests/processor/timing_table.hpp"

namespace processor {

class TimeModel {
 public:
  // `bus_wait`: clocks from a request on the bus to its response.
  TimeModel(const TimingTable& table, unsigned bus_wait) : table_(table), bus_wait_(bus_wait) {}

  // Of each clock of the chip, from the first on: what is requested in it.
  void note_requests(std::uint32_t requests) { requests_.push_back(requests); }

  struct Prediction {
    std::uint64_t clock = 0;
    bool interrupt = false;
  };
  // When the next instruction of `model` retires or traps, or that it is interrupted, and when;
  // nothing if it sleeps beyond the last clock noted, or before the first event has been noted.
  std::optional<Prediction> next(const InstructionSetModel& model) const;

  // An event of the chip, and the model before it.
  void note(const Retirement& event, const InstructionSetModel& model_before);

 private:
  // The first of these clocks in which a request of the clock before is seen; 0 for none.
  std::uint64_t first_active(std::uint64_t from, std::uint64_t to, std::uint32_t enabled) const;
  unsigned clocks_behind(const Retirement& event, const InstructionSetModel& model) const;

  const TimingTable& table_;
  unsigned bus_wait_;
  std::vector<std::uint32_t> requests_;
  bool begun_ = false;
  // Of the last event: its clock, its penalty to the next instruction, the clocks in which no
  // interrupt can be taken, the destination of its late result (0: none).
  std::uint64_t clock_ = 0;
  unsigned behind_ = 0;
  unsigned closed_ = 0;
  unsigned late_register_ = 0;
};

}  // namespace processor
