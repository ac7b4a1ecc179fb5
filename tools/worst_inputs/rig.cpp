// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/rig.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <deque>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "application/statistics.hpp"
#include "tools/process/branch.hpp"
#include "tools/timing/calls.hpp"

namespace worst_inputs {

namespace {

using application::Statistics;

// The words of the statistics that hold the longest times.
constexpr std::array<std::uint32_t, pass_place + 1> words = [] {
  std::array<std::uint32_t, pass_place + 1> places{};
  for (std::uint32_t task = 0; task < units::task_count; ++task) {
    const std::size_t place = offsetof(Statistics, tasks) + task * sizeof(application::TaskTimes);
    places[task] = static_cast<std::uint32_t>(place / 4);
  }
  places[pass_place] = offsetof(Statistics, longest_pass_clocks) / 4;
  return places;
}();
constexpr double hotend_c = 200, bed_c = 60;
constexpr double boot_s = 0.4;
constexpr std::uint32_t clocks_per_bit = 4;  // the fastest serial line that is offered
// Without a reference the limits of the axes do not count.
constexpr std::string_view preparation = "M104 S200\nM140 S60\nG28\nG1 X100 Y100 Z10 F9000\nM400\n";
constexpr double most_preparation_s = 100;
constexpr double look_s = 0.001;
// Of an input where there are many, of one that is looked at clock by clock, and of a start.
constexpr double longest_s = 0.024, longest_watched_s = 2, longest_start_s = 2;
// A pass has always ended before: a line waits for room, heat, time, an end stop or the user.
constexpr int looks_of_a_wait = 14;
// For the rest of the pass that has executed the last line, and for the one behind it.
constexpr int looks_behind = 8;

std::uint32_t address_of(const sim::ElfImage& firmware, const char* name) {
  const auto address = firmware.symbol(name);
  if (!address) throw std::runtime_error(std::string("the firmware has no symbol ") + name);
  return *address;
}

}  // namespace

Rig::Rig(const sim::ElfImage& firmware, const machine::Description& description,
         std::uint32_t clock_hz)
    : statistics_(address_of(firmware, "statistics")),
      chip_(clock_hz),
      simulation_(chip_, sim::ClockRate(clock_hz)),
      printer_(description,
               {.baud = clock_hz / clocks_per_bit,
                .hotend_start_c = hotend_c,
                .bed_start_c = bed_c,
                .faults = {}},
               simulation_) {
  sim::load(firmware, chip_);
  chip_.write_memory(address_of(firmware, "serial_baud"), clock_hz / clocks_per_bit);
  run_for(boot_s);
  printer_.serial_line().send(simulation_.now(), preparation);
  for (double time = 0; time < most_preparation_s; time += look_s) {
    run_for(look_s);
    if (is_idle()) return;
  }
  throw std::runtime_error("the printer was not prepared in time");
}

std::uint32_t Rig::word(std::uint32_t index) const {
  return chip_.read_memory(statistics_ + 4 * index);
}

std::uint32_t Rig::lines_done() const {
  return word(offsetof(Statistics, commands_executed) / 4) +
         word(offsetof(Statistics, commands_refused) / 4) +
         word(offsetof(Statistics, lines_withdrawn) / 4);
}

std::uint32_t Rig::lines_accepted() const { return word(offsetof(Statistics, lines_accepted) / 4); }

bool Rig::is_idle() { return printer_.serial_line().quiet() && lines_done() == lines_accepted(); }

void Rig::run_for(double seconds) {
  const sim::Clock end = simulation_.now() + simulation_.rate().clocks(seconds);
  if (!each_clock_) simulation_.run_until(end);
  while (simulation_.now() < end) {
    simulation_.run_until(simulation_.now() + 1);
    each_clock_();
  }
}

// Until all lines are done, in so many looks one after the other, for what may follow them; or
// until they wait for something else, or have taken long.
void Rig::settle(int idle_looks, sim::Clock end) {
  int idle = 0, without_progress = 0;
  std::uint32_t before = 0;
  while (simulation_.now() < end && idle < idle_looks && without_progress < looks_of_a_wait) {
    run_for(look_s);
    idle = is_idle() ? idle + 1 : 0;
    const std::uint32_t now = lines_done() + lines_accepted();
    const bool waits = now == before && printer_.serial_line().quiet();
    without_progress = waits ? without_progress + 1 : 0;
    before = now;
  }
}

// All slices one behind the other, as bytes.
std::string Rig::measure_here(const std::vector<SerialInput>& inputs, unsigned at_once) {
  const sim::Clock now = simulation_.now();
  std::string measured;
  std::deque<process::Branch> under_way;
  const auto collect = [&] {
    measured += under_way.front().result();
    under_way.pop_front();
  };
  for (const SerialInput& input : inputs) {
    if (under_way.size() >= std::max(at_once, 1U)) collect();
    under_way.emplace_back([&] {
      const Slices slices = run(input, now + simulation_.rate().clocks(longest_s));
      return std::string(reinterpret_cast<const char*>(slices.data()), sizeof slices);
    });
  }
  while (!under_way.empty()) collect();
  return measured;
}

std::vector<Slices> Rig::measure(const SerialInput& start, const std::vector<SerialInput>& inputs,
                                 unsigned at_once) {
  process::Branch branch([&] {
    send(start, simulation_.now() + simulation_.rate().clocks(longest_start_s));
    return measure_here(inputs, at_once);
  });
  const std::string bytes = branch.result();
  std::vector<Slices> measured(inputs.size());
  if (bytes.size() != inputs.size() * sizeof(Slices)) {
    throw std::runtime_error("a measurement was cut short");
  }
  std::memcpy(measured.data(), bytes.data(), bytes.size());
  return measured;
}

std::vector<std::uint64_t> Rig::longest_calls(const SerialInput& start, const SerialInput& input,
                                              const timing::Program& program, bool has_zbb,
                                              const std::vector<timing::Address>& functions) {
  process::Branch branch([&] {
    send(start, simulation_.now() + simulation_.rate().clocks(longest_start_s));
    timing::Calls calls(program, has_zbb);
    each_clock_ = [&] { calls.take(timing::sample_of(chip_.processor_statistics())); };
    run(input, simulation_.now() + simulation_.rate().clocks(longest_watched_s));
    std::string text;
    for (const timing::Address function : functions) {
      const auto found = calls.measured().find(function);
      text += std::to_string(found == calls.measured().end() ? 0 : found->second.longest) + ' ';
    }
    return text;
  });
  std::istringstream text(branch.result());
  std::vector<std::uint64_t> longest(functions.size());
  for (std::uint64_t& clocks : longest) text >> clocks;
  return longest;
}

void Rig::send(const SerialInput& input, sim::Clock end) {
  for (const Piece& piece : input) {
    if (piece.waits) settle(1, end);
    run_for(1e-6 * piece.pause_us);
    if (!piece.bytes.empty()) printer_.serial_line().send(simulation_.now(), piece.bytes);
  }
}

Slices Rig::run(const SerialInput& input, sim::Clock end) {
  for (const std::uint32_t word : words) chip_.write_memory(statistics_ + 4 * word, 0);
  send(input, end);
  settle(looks_behind, end);
  Slices slices;
  std::ranges::transform(words, slices.begin(),
                         [this](std::uint32_t place) { return word(place); });
  return slices;
}

}  // namespace worst_inputs
