// SPDX-License-Identifier: Apache-2.0
// What `bench processor` measures: works of this project's own and the firmware's hottest code, in
// clocks, so exact and the same on every machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/processor_run.hpp"

namespace benchmarks {

// A work as it was compiled for one instruction set.
struct CompiledWork {
  WorkRun run;
  std::uint32_t code_bytes{};  // of the program, with its frame and constants
};

struct WorkFigure {
  std::string name;
  std::string unit;  // what result.units counts
  std::string file;  // the G-code that it worked on
  std::uint32_t iterations{};
  CompiledWork compressed, uncompressed, with_zbb;  // RV32IMC, RV32IM, RV32IMC with Zbb

  double clocks_per_instruction() const {
    return double(compressed.run.use.clocks()) / double(compressed.run.use.instructions());
  }
  double clocks_per_unit() const { return clocks_per_unit(compressed); }
  double clocks_per_unit_with_zbb() const { return clocks_per_unit(with_zbb); }

 private:
  static double clocks_per_unit(const CompiledWork& work) {
    return double(work.run.use.clocks()) / work.run.result.units;
  }
};

struct ProcessorFigures {
  std::vector<WorkFigure> works;
  std::uint32_t firmware_bytes{};  // code and constants, without the boot loader
  std::uint32_t firmware_bytes_uncompressed{};
  std::uint32_t firmware_bytes_with_zbb{};
};

struct ProcessorScope {
  std::filesystem::path programs;  // the folder of the .elf files
  std::filesystem::path examples;  // the folder of the G-code files
  bool quick = false;  // one iteration of each, to see that all works
  std::vector<std::string> works;  // core, record, parser, planner; none: all
};

// Throws std::runtime_error where a program computes other results than the same code on this
// machine, or a work is unknown. `say` is called with what is measured now.
ProcessorFigures measure_processor(const ProcessorScope& scope,
                                   const std::function<void(const std::string&)>& say);

// Lines of G0 and G1 from a third of the file on, without comments, as many as fit.
std::string moves_of(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace benchmarks
