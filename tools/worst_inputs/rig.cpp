// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/rig.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "application/statistics.hpp"

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
// Lines are done before that, unless one waits for heat, time, an end stop or the user.
constexpr double longest_s = 0.2, look_s = 0.004;

std::uint32_t statistics_of(const sim::ElfImage& firmware) {
  const auto address = firmware.symbol("statistics");
  if (!address) throw std::runtime_error("the firmware has no symbol `statistics`");
  return *address;
}

}  // namespace

Rig::Rig(const sim::ElfImage& firmware, const machine::Description& description,
         std::uint32_t clock_hz)
    : firmware_(firmware),
      statistics_(statistics_of(firmware)),
      chip_(clock_hz),
      simulation_(chip_, sim::ClockRate(clock_hz)),
      printer_(description,
               {.baud = description.baud,
                .hotend_start_c = hotend_c,
                .bed_start_c = bed_c,
                .faults = {}},
               simulation_) {
  sim::load(firmware_, chip_);
  run_for(boot_s);
}

std::uint32_t Rig::word(std::uint32_t index) const {
  return chip_.read_memory(statistics_ + 4 * index);
}

bool Rig::is_idle() {
  const std::uint32_t done = word(offsetof(Statistics, commands_executed) / 4) +
                             word(offsetof(Statistics, commands_refused) / 4) +
                             word(offsetof(Statistics, lines_withdrawn) / 4);
  return printer_.serial_line().quiet() && done == word(offsetof(Statistics, lines_accepted) / 4);
}

void Rig::run_for(double seconds) {
  simulation_.run_until(simulation_.now() + simulation_.rate().clocks(seconds));
}

// True where all lines are done in the end, also after what may follow them.
bool Rig::settle() {
  constexpr int idle_looks = 3;
  int idle = 0;
  for (double time = 0; time < longest_s && idle < idle_looks; time += look_s) {
    run_for(look_s);
    idle = is_idle() ? idle + 1 : 0;
  }
  return idle != 0;
}

void Rig::reset() {
  ++resets_;
  chip_.reset();
  sim::load(firmware_, chip_);
  run_for(boot_s);
}

Slices Rig::measure(const SerialInput& input) {
  for (const std::uint32_t word : words) chip_.write_memory(statistics_ + 4 * word, 0);
  for (const Piece& piece : input) {
    run_for(1e-6 * piece.pause_us);
    printer_.serial_line().send(simulation_.now(), piece.bytes);
  }
  const bool settled = settle();
  Slices slices;
  std::ranges::transform(words, slices.begin(),
                         [this](std::uint32_t place) { return word(place); });
  if (!settled || word(offsetof(Statistics, halted) / 4) != 0) reset();
  return slices;
}

}  // namespace worst_inputs
