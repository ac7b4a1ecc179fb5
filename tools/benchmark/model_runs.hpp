// SPDX-License-Identifier: Apache-2.0
// One measured run of the chip's Verilated model: asleep, printing, serving or computing.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>

#include "sim/machine/description.hpp"
#include "sim/simulation/chip.hpp"
#include "sim/simulation/edges.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/evaluation_counts.hpp"
#include "tools/benchmark/activity_samples.hpp"

namespace benchmarks {

inline constexpr std::uint32_t model_clock_hz = 4'000'000;  // the default of `print`
inline constexpr std::uint32_t board_clock_hz = 50'000'000;

struct ModelScope {
  sim::ElfImage firmware;
  machine::Description machine;  // that the firmware is built for
  std::filesystem::path print_file;  // lines that the firmware prints
  sim::ElfImage computing;  // `core` of `bench processor`, which never sleeps
  bool quick = false;  // few clocks, once
  std::function<void()> look = [] {};  // called many times a second; what it throws ends all
};

// What the chip is simulated by: as `print` does it; with the processor's netlist; without leaps;
// every edge by eval().
enum class ModelKind : std::uint8_t { usual, whole_netlist, resting, all_edges };

// Of a run with a profile.
struct Profile {
  double seconds{};  // of the simulation's thread
  ActivityCounts samples{};  // of these
  sim::EvaluationCounts evaluations;
};

struct Measured {
  double seconds{};  // of processor time, of all threads
  sim::Clock clocks{};
  sim::ProcessorStatistics processor;
  Profile profile;
};

struct ModelRun {
  ModelKind kind = ModelKind::usual;
  std::uint32_t clock_hz = model_clock_hz;
  bool profiled = false;
};

// All throw std::runtime_error where a program does not do what it should.

// The firmware with nothing to do.
Measured run_asleep(const ModelScope& scope, const ModelRun& run);
// It prints. With a profile a report is recorded as `print` does it.
Measured run_printing(const ModelScope& scope, const ModelRun& run);
// As `serve` has it, as fast as it goes: the host is another thread, whose time counts as well.
Measured run_served(const ModelScope& scope, const ModelRun& run);
Measured run_computing(const ModelScope& scope, const ModelRun& run);

struct NamedRun {
  const char* name;
  std::uint32_t clock_hz;
  Measured (*run)(const ModelScope& scope, const ModelRun& run);
};

inline constexpr std::array<NamedRun, 6> model_works{{
    {"asleep", model_clock_hz, run_asleep},
    {"printing", model_clock_hz, run_printing},
    {"printing at 50 MHz", board_clock_hz, run_printing},
    {"serving", model_clock_hz, run_served},
    {"computing", model_clock_hz, run_computing},
    {"serving at 50 MHz", board_clock_hz, run_served},
}};

}  // namespace benchmarks
