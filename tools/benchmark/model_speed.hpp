// SPDX-License-Identifier: Apache-2.0
// How fast the Verilated model of the chip runs on this machine: asleep, printing, serving
// a host and computing.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/model_runs.hpp"

namespace benchmarks {

struct ModelWork {
  std::string name;
  std::uint32_t clock_hz{};
  std::uint64_t clocks{};  // measured ones
  double awake{};  // share of these in which the processor does not sleep
  double instructions_per_clock{};
  // Clocks per second of processor time, the best of several runs, by kind of model; 0 if
  // not measured.
  std::array<double, 4> clocks_per_second{};

  double speed(ModelKind kind) const { return clocks_per_second[static_cast<std::size_t>(kind)]; }
  // Simulated seconds in one of processor time; from 1 on it is as fast as the chip.
  double pace() const { return speed(ModelKind::usual) / clock_hz; }
};

// Runs of all kinds alternate, so that load on the machine affects all alike. Throws
// std::runtime_error where a program does not do what it should.
std::vector<ModelWork> measure_model(const ModelScope& scope,
                                     const std::function<void(const std::string&)>& say);

std::string to_json(const std::vector<ModelWork>& works);
std::string to_table(const std::vector<ModelWork>& works);

}  // namespace benchmarks
