// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/rig.hpp"

#include <fmt/format.h>

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
// Lines that wait for room, heat, time, an end stop or the user; the pass behind the last line.
constexpr int looks_of_a_wait = 4, looks_behind = 3;

std::uint32_t address_of(const sim::ElfImage& firmware, const char* name) {
  const auto address = firmware.symbol(name);
  if (!address) throw std::runtime_error(std::string("the firmware has no symbol ") + name);
  return *address;
}

}  // namespace

Rig::Rig(const sim::ElfImage& firmware, const machine::Description& description,
         std::uint32_t clock_hz, sim::Clock longest_pass)
    : longest_pass_(longest_pass),
      statistics_(address_of(firmware, "statistics")),
      boot_loader_(address_of(firmware, "_boot_loader")),
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
  run_for(clocks(boot_s));
  printer_.serial_line().send(simulation_.now(), preparation);
  for (double time = 0; time < most_preparation_s; time += look_s) {
    run_for(clocks(look_s));
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

void Rig::run_for(sim::Clock clocks) {
  const sim::Clock end = simulation_.now() + clocks;
  if (!each_clock_) simulation_.run_until(end);
  while (simulation_.now() < end) {
    simulation_.run_until(simulation_.now() + 1);
    each_clock_();
  }
}

sim::Clock Rig::clocks(double seconds) const { return simulation_.rate().clocks(seconds); }

// No pass is under way.
bool Rig::is_asleep() {
  constexpr sim::Clock some = 4;
  const std::uint64_t before = chip_.processor_statistics().sleeping_clocks;
  run_for(some);
  return chip_.processor_statistics().sleeping_clocks == before + some;
}

// Until all lines are done, or wait for something else, in so many looks that find the processor
// asleep; or until the end.
void Rig::settle(int looks, sim::Clock end) {
  int idle = 0, waiting = 0;
  std::uint32_t before = 0;
  while (simulation_.now() < end && idle < looks && waiting < looks_of_a_wait) {
    run_for(clocks(look_s));
    const std::uint32_t now = lines_done() + lines_accepted();
    if (now != before || !printer_.serial_line().quiet()) idle = waiting = 0;
    before = now;
    if (!is_asleep()) continue;
    ++waiting;
    if (is_idle()) ++idle;
  }
}

// M997 ends the firmware's loop: the boot loader has none, and waits without sleep.
bool Rig::is_in_boot_loader() const {
  return chip_.processor_statistics().program_counter >= boot_loader_;
}

// What is under way counts too.
void Rig::end_pass() {
  const sim::Clock end = simulation_.now() + longest_pass_;
  while (!is_asleep() && !is_in_boot_loader()) {
    if (simulation_.now() < end) {
      run_for(clocks(look_s / 4));
      continue;
    }
    // One pass follows the other, or one has no end.
    const std::uint32_t longest = word(words.back());
    chip_.write_memory(statistics_ + 4 * words.back(), 0);
    run_for(longest_pass_);
    const std::uint32_t since = word(words.back());
    if (since == 0 && !is_in_boot_loader()) {
      throw std::runtime_error(fmt::format("a pass takes more than {} clocks", longest_pass_));
    }
    chip_.write_memory(statistics_ + 4 * words.back(), std::max(longest, since));
    return;
  }
}

// All slices one behind the other, as bytes.
std::string Rig::measure_here(const std::vector<SerialInput>& inputs, unsigned at_once) {
  std::string measured;
  std::deque<process::Branch> under_way;
  const auto collect = [&] {
    measured += under_way.front().result();
    under_way.pop_front();
  };
  for (const SerialInput& input : inputs) {
    if (under_way.size() >= std::max(at_once, 1U)) collect();
    under_way.emplace_back([&] {
      try {
        const Slices slices = run(input, simulation_.now() + clocks(longest_s));
        return std::string(reinterpret_cast<const char*>(slices.data()), sizeof slices);
      } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{}: {}", text_of(input), error.what()));
      }
    });
  }
  while (!under_way.empty()) collect();
  return measured;
}

std::vector<Slices> Rig::measure(const SerialInput& start, const std::vector<SerialInput>& inputs,
                                 unsigned at_once) {
  process::Branch branch([&] {
    send(start, simulation_.now() + clocks(longest_start_s));
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
    send(start, simulation_.now() + clocks(longest_start_s));
    timing::Calls calls(program, has_zbb);
    each_clock_ = [&] { calls.take(timing::sample_of(chip_.processor_statistics())); };
    run(input, simulation_.now() + clocks(longest_watched_s));
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

// Pauses do not count.
sim::Clock Rig::send(const SerialInput& input, sim::Clock end) {
  for (const Piece& piece : input) {
    if (piece.waits) settle(1, end);
    const sim::Clock pause = clocks(1e-6 * piece.pause_us);
    run_for(pause);
    end += pause;
    if (!piece.bytes.empty()) printer_.serial_line().send(simulation_.now(), piece.bytes);
  }
  return end;
}

Slices Rig::run(const SerialInput& input, sim::Clock end) {
  for (const std::uint32_t word : words) chip_.write_memory(statistics_ + 4 * word, 0);
  settle(looks_behind, send(input, end));
  end_pass();
  Slices slices;
  std::ranges::transform(words, slices.begin(),
                         [this](std::uint32_t place) { return word(place); });
  return slices;
}

}  // namespace worst_inputs
