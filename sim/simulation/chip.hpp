// SPDX-License-Identifier: Apache-2.0
// The chip as the co-simulation needs it: pins, clocks, memory and counters, independent of
// the model.
#pragma once

#include <cstdint>
#include <string>

#include "sim/simulation/pins.hpp"

namespace sim {

// Counters of the step generator's queue, read from inside the model.
struct QueueStatistics {
  std::uint64_t underruns{};
  std::uint64_t guard_stall_clocks{};
  std::uint32_t depth{};  // segments waiting now
  std::uint32_t max_depth{};  // largest depth ever
};

struct ProcessorStatistics {
  std::uint64_t sleeping_clocks{};
  std::uint64_t instructions{};
  // Of the processor's model only, and of the next instruction: its address, the clock in which it
  // begins, whether it is an access of the bus.
  std::uint32_t program_counter{};
  std::uint64_t begins{};
  bool accesses{};
};

class Chip {
 public:
  Chip() = default;
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;
  virtual ~Chip() = default;

  // Clocks until an output pin changes or `now() == limit`, whichever comes first; at least one
  // clock if limit > now().
  virtual void advance(Clock limit) = 0;

  // As the reset pin does it: everything starts over, but the memory stays as it is. Time goes on.
  virtual void reset() = 0;

  // RAM, at addresses of the processor, word by word. Throws std::out_of_range outside it.
  virtual std::uint32_t read_memory(std::uint32_t address) const = 0;
  virtual void write_memory(std::uint32_t address, std::uint32_t word) = 0;

  virtual QueueStatistics queue_statistics() const = 0;
  virtual ProcessorStatistics processor_statistics() const = 0;

  // Writes a waveform of all signals from now on. Throws std::runtime_error where the model cannot.
  virtual void trace_to(const std::string& file) = 0;

  Clock now() const { return now_; }
  OutputPins outputs() const { return outputs_; }
  InputPins& inputs() { return inputs_; }

 protected:
  Clock now_ = 0;
  OutputPins outputs_;
  InputPins inputs_;
};

}  // namespace sim
