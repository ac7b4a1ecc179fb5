// SPDX-License-Identifier: Apache-2.0
// From the state of a snapshot to the next one.
#include "sim/replay/replay_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "sim/replay/netlist_replay.hpp"
#include "sim/replay/pin_names.hpp"
#include "sim/replay/processor_registers.hpp"
#include "sim/replay/processor_snapshot.hpp"

namespace replay {

namespace {

constexpr std::uint32_t memory_start = 0x8000'0000;
// From its first fetch to rest in wfi the processor needs about ten clocks.
constexpr int most_clocks_to_sleep = 50;

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  std::string text = "0x";
  for (const std::uint8_t byte : std::views::reverse(bytes)) text += fmt::format("{:02x}", byte);
  return text;
}

Difference difference_of(sim::Clock clock, std::string what, std::string recorded,
                         std::string replayed) {
  return {.interval = 0,
          .clock = clock,
          .what = std::move(what),
          .recorded = std::move(recorded),
          .replayed = std::move(replayed)};
}

std::optional<Difference> pin_difference(sim::Clock clock, sim::OutputPins recorded,
                                         sim::OutputPins replayed) {
  if (recorded == replayed) return std::nullopt;
  return difference_of(clock, "pins " + pin_names(recorded.word ^ replayed.word),
                       fmt::format("{:#018x}", recorded.word),
                       fmt::format("{:#018x}", replayed.word));
}

}  // namespace

ReplayModel::ReplayModel(std::uint32_t clock_hz, bool software_stepping, sim::Edges edges)
    : NetlistModel(clock_hz, edges),
      edges_(edges),
      registers_(registers_of_whole_chip(*model_->rootp)) {
  if (sim::ModelFunctions<Model>::settle == nullptr) {
    throw std::runtime_error(
        "this version of Verilator makes models that cannot be put into a state");
  }
  if (software_stepping) permit_software_stepping();
}

// The timer's samples of its time, taken with the processor's last clock. The netlist has one until
// the processor sleeps, the chip with the model only while the bus is used. Both take another
// sample before a program can read one.
bool ReplayModel::is_compared(std::string_view name) {
  return name != "printer_core__DOT__machine_timer__DOT__seen_cycles_q" &&
         name != "printer_core__DOT__machine_timer__DOT__earlier_high_q";
}

// The sensors' sample of the time. Without rests it is taken with every clock; a block that rests
// takes none, and another one before a sensor or a program can use it.
bool ReplayModel::is_sample(std::string_view name) {
  return name == "printer_core__DOT__thermal__DOT__sensors__DOT__seen_cycles_q";
}

void ReplayModel::put_registers(const Snapshot& snapshot) {
  put_processor_registers(*model_->rootp, snapshot.processor);
  auto saved = snapshot.registers.begin();
  for (const Register& chip_register : registers_) {
    std::copy_n(saved, chip_register.bytes, chip_register.place);
    saved += static_cast<std::ptrdiff_t>(chip_register.bytes);
  }
  sim::ModelFunctions<Model>::settle(model_->rootp);
}

void ReplayModel::put(const Snapshot& snapshot, const sim::InputPins& inputs) {
  now_ = snapshot.clock;
  inputs_ = inputs;
  reset();
  for (std::size_t i = 0; i < snapshot.memory.size(); ++i) {
    write_memory(memory_start + 4 * static_cast<std::uint32_t>(i), snapshot.memory[i]);
  }
  processor_ = snapshot.statistics;
  put_program_counter(*model_->rootp, snapshot.processor.program_counter);
  put_registers(snapshot);
  outputs_ = sampled_outputs();
  if (snapshot.in_reset) return;

  // The pipeline fetches the wfi and falls asleep in it, while nothing else has a clock.
  started_ = true;
  model_->reset = 0;
  for (int i = 0; !model_->at_rest_processor; ++i) {
    if (i == most_clocks_to_sleep) {
      throw std::runtime_error(
          fmt::format("the netlist does not sleep at {:#x}", snapshot.processor.program_counter));
    }
    clocks_->clock_processor();
  }
  // These clocks do not count.
  put_registers(snapshot);
}

std::optional<Difference> ReplayModel::difference(const Snapshot& snapshot) const {
  if (auto pins = pin_difference(now_, snapshot.outputs, outputs_)) return pins;
  if (auto processor = processor_difference(snapshot)) return processor;
  if (auto chip_register = register_difference(snapshot)) return chip_register;
  return memory_difference(snapshot);
}

std::optional<Difference> ReplayModel::processor_difference(const Snapshot& snapshot) const {
  auto recorded = named_values(snapshot.processor);
  auto replayed = named_values(processor_registers(std::as_const(*model_->rootp)));
  recorded.emplace_back("sleeping", 1);
  replayed.emplace_back("sleeping", model_->sleeping);
  recorded.emplace_back("instructions", snapshot.statistics.instructions);
  replayed.emplace_back("instructions", processor_.instructions);
  recorded.emplace_back("clocks asleep", snapshot.statistics.sleeping_clocks);
  replayed.emplace_back("clocks asleep", processor_.sleeping_clocks);
  const auto [first, found] = std::ranges::mismatch(recorded, replayed);
  if (first == recorded.end()) return std::nullopt;
  return difference_of(now_, first->first, fmt::format("{:#x}", first->second),
                       fmt::format("{:#x}", found->second));
}

std::optional<Difference> ReplayModel::register_difference(const Snapshot& snapshot) const {
  std::span<const std::uint8_t> saved = snapshot.registers;
  for (const Register& chip_register : registers_) {
    const auto recorded = saved.first(chip_register.bytes);
    saved = saved.subspan(chip_register.bytes);
    const std::span<const std::uint8_t> replayed = chip_register.contents();
    const auto byte = std::ranges::mismatch(recorded, replayed).in1 - recorded.begin();
    if (byte == std::ssize(recorded) || !is_compared(chip_register.name)) continue;
    if (edges_ == sim::Edges::all && is_sample(chip_register.name)) continue;
    const std::size_t size = chip_register.element_bytes;
    const std::size_t element = static_cast<std::size_t>(byte) / size;
    return difference_of(now_, fmt::format("{}[{}]", chip_register.name, element),
                         hexadecimal(recorded.subspan(element * size, size)),
                         hexadecimal(replayed.subspan(element * size, size)));
  }
  return std::nullopt;
}

std::optional<Difference> ReplayModel::memory_difference(const Snapshot& snapshot) const {
  for (std::size_t i = 0; i < snapshot.memory.size(); ++i) {
    const std::uint32_t address = memory_start + 4 * static_cast<std::uint32_t>(i);
    const std::uint32_t word = read_memory(address);
    if (word == snapshot.memory[i]) continue;
    return difference_of(now_, fmt::format("memory at {:#x}", address),
                         fmt::format("{:#010x}", snapshot.memory[i]),
                         fmt::format("{:#010x}", word));
  }
  return std::nullopt;
}

std::optional<Difference> ReplayModel::replay(const Interval& interval) {
  put(*interval.start, interval.inputs.front().pins);
  std::optional<Difference> difference = pin_difference(now_, interval.start->outputs, outputs_);
  std::span<const OutputChange> outputs = interval.outputs;
  std::span<const InputChange> inputs(interval.inputs);
  while (now_ < interval.end_clock && !difference) {
    while (!inputs.empty() && inputs.front().clock <= now_) {
      inputs_ = inputs.front().pins;
      inputs = inputs.subspan(1);
    }
    const sim::OutputPins before = outputs_;
    // Not beyond a change that was recorded, so that one that is missing is found there.
    sim::Clock limit = interval.end_clock;
    if (!inputs.empty()) limit = std::min(limit, inputs.front().clock);
    if (!outputs.empty()) limit = std::min(limit, outputs.front().clock);
    advance(limit);
    sim::OutputPins recorded = before;
    if (!outputs.empty() && outputs.front().clock == now_) {
      recorded = outputs.front().pins;
      outputs = outputs.subspan(1);
    }
    difference = pin_difference(now_, recorded, outputs_);
  }
  // No further change came, so the recorded ones beyond are missing.
  if (!difference && !outputs.empty()) {
    difference = pin_difference(outputs.front().clock, outputs.front().pins, outputs_);
  }
  if (!difference && interval.end) difference = this->difference(*interval.end);
  if (difference) difference->interval = interval.number;
  return difference;
}

Replay make_netlist_replay(std::uint32_t clock_hz, bool software_stepping, sim::Edges edges) {
  auto model = std::make_shared<ReplayModel>(clock_hz, software_stepping, edges);
  return [model](const Interval& interval) { return model->replay(interval); };
}

}  // namespace replay
