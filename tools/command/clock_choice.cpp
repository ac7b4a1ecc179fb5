// SPDX-License-Identifier: Apache-2.0
// Timing the model under the load of a print.
#include "tools/command/clock_choice.hpp"

#include <chrono>
#include <string>
#include <vector>

#include "sim/devices/file_host.hpp"
#include "sim/machine/surroundings.hpp"
#include "tools/command/printer_setup.hpp"

namespace command {

namespace {

using Time = std::chrono::steady_clock;

constexpr std::uint32_t trial_clock_hz = 4'000'000;
constexpr std::chrono::milliseconds trial_time{1000};
// Between two readings of the real-time clock.
constexpr double chunk_seconds = 0.01;
// The host program and everything else on this machine need processor time too.
constexpr double usable_share = 0.75;
constexpr std::uint32_t round_clocks_hz[] = {50'000'000, 25'000'000, 16'000'000, 12'000'000,
                                             8'000'000,  6'000'000,  5'000'000,  4'000'000,
                                             3'000'000,  2'500'000};

// More short moves than any machine simulates within the trial.
std::vector<devices::FileCommand> trial_job() {
  constexpr std::size_t moves = 20'000;
  std::vector<devices::FileCommand> job{{1, "G91"}, {2, "G1 F3000"}};
  for (std::size_t line = 3; line < moves; line += 2) {
    job.push_back({line, "G1 X0.31 Y0.17"});
    job.push_back({line + 1, "G1 X-0.31 Y-0.17"});
  }
  return job;
}

}  // namespace

ClockChoice clock_that_keeps_up(const PrinterChoices& choices) {
  PrinterChoices trial = choices;
  trial.clock_hz = trial_clock_hz;
  trial.baud.reset();
  trial.faults.clear();
  PrinterSetup setup(trial, {machine::ambient_celsius, machine::ambient_celsius});
  sim::Simulation& simulation = setup.simulation();
  devices::FileHost host(trial_job(), setup.printer().serial_line(), simulation.rate());
  simulation.attach(host, {});
  setup.printer().serial_line().set_listener(host);

  const sim::Clock chunk = simulation.rate().clocks(chunk_seconds);
  const Time::time_point began = Time::now();
  while (Time::now() - began < trial_time && !host.ended()) {
    simulation.run_until(simulation.now() + chunk);
  }
  const double seconds = std::chrono::duration<double>(Time::now() - began).count();
  const double speed = static_cast<double>(simulation.now()) / seconds;
  for (const std::uint32_t clock_hz : round_clocks_hz) {
    if (clock_hz <= usable_share * speed) return {clock_hz, speed};
  }
  return {lowest_serve_clock_hz, speed};
}

}  // namespace command
