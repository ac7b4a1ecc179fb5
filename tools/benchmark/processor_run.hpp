// SPDX-License-Identifier: Apache-2.0
// One run of a program of `bench processor` on the Verilated processor with its memory.
#pragma once

#include <string>

#include "firmware/benchmark/processor.hpp"
#include "sim/simulation/elf_image.hpp"
#include "tools/benchmark/clock_use.hpp"

namespace benchmarks {

struct WorkRun {
  benchmark::ProcessorResult result{};
  ClockUse use;  // from the first mark's return to the call of the second
};

// `text` is put into the program's order. Throws std::runtime_error where the program does not end,
// traps, or is none of these.
WorkRun run_work(const sim::ElfImage& program, std::uint32_t iterations, const std::string& text);

}  // namespace benchmarks
