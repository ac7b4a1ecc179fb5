// SPDX-License-Identifier: Apache-2.0
// A chip for tests of the world around it: its pins do what a test plans, its serial
// line answers lines.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sim/simulation/chip.hpp"

namespace tests {

class FakeChip : public sim::Chip {
 public:
  static constexpr std::uint32_t memory_start = 0x8000'0000;

  explicit FakeChip(sim::Clock clocks_per_bit = 16);

  // Plans a level of an output pin (a bit of sim::OutputPins).
  void plan(sim::Clock clock, unsigned bit, bool level);
  // Plans a step pulse with its direction set `setup` clocks before. Direction high = backward.
  void plan_step(sim::Clock clock, std::size_t axis, bool backward, sim::Clock high = 8,
                 sim::Clock setup = 8);

  // Called with every line that comes in over the serial line; what it returns is sent back.
  std::function<std::string(const std::string& line)> firmware;
  // Plans bytes on the transmit pin, after those that still wait.
  void say(const std::string& text);

  void advance(sim::Clock limit) override;
  void reset() override { ++resets; }
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  sim::QueueStatistics queue_statistics() const override { return queue; }
  sim::ProcessorStatistics processor_statistics() const override { return processor; }
  void trace_to(const std::string&) override { throw std::runtime_error("no traces"); }

  unsigned resets = 0;
  unsigned breaks = 0;  // on the receive pin
  sim::QueueStatistics queue;
  sim::ProcessorStatistics processor;

 private:
  void watch_receive_pin();
  void receive_bit();
  void wait_for_rest();

  sim::Clock clocks_per_bit_;
  std::multimap<sim::Clock, std::function<void()>> plans_;
  sim::Clock line_free_at_ = 0;
  bool receiving_ = false;
  unsigned bits_ = 0;
  unsigned frame_ = 0;
  std::string line_;
  std::vector<std::uint32_t> memory_;
};

}  // namespace tests
