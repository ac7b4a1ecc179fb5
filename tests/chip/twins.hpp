// SPDX-License-Identifier: Apache-2.0
// Two chips with the same inputs, which the simulation sees as one: their pins must be equal in
// every clock.
#pragma once

#include <stdexcept>
#include <string>

#include "sim/simulation/chip.hpp"

namespace tests {

// The chips differ: what() gives the clock and the pins.
class TwinsDiffer : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Memory, counters and waveforms are those of the first chip.
class Twins : public sim::Chip {
 public:
  // Throws TwinsDiffer.
  void advance(sim::Clock limit) override;
  // The program is written into the first chip only.
  void write_memory(std::uint32_t address, std::uint32_t word) override {
    first_.write_memory(address, word);
  }
  std::uint32_t read_memory(std::uint32_t address) const override {
    return first_.read_memory(address);
  }
  sim::QueueStatistics queue_statistics() const override { return first_.queue_statistics(); }
  sim::ProcessorStatistics processor_statistics() const override {
    return first_.processor_statistics();
  }
  void trace_to(const std::string& file) override { first_.trace_to(file); }
  void reset() override;

 protected:
  // Both are members of the derived class, whose constructor calls compare() when they are there.
  Twins(sim::Chip& first, sim::Chip& second) : first_(first), second_(second) {}

  void compare();
  // What the second chip's pins must be.
  virtual sim::OutputPins expected_outputs() const { return first_.outputs(); }

 private:
  sim::Chip& first_;
  sim::Chip& second_;
};

}  // namespace tests
