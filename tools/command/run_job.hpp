// SPDX-License-Identifier: Apache-2.0
// `run`: a bare-metal program on the chip, to its store to `tohost`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace sim {
class Chip;
struct ElfImage;
}  // namespace sim

namespace CLI {
class App;
}

namespace command {

struct RunOptions {
  std::filesystem::path program;
  std::uint64_t max_cycles = 100'000'000;
  std::uint32_t clock_hz = 50'000'000;
  std::optional<std::uint32_t> baud;  // shows what the program writes to the serial line
  std::filesystem::path signature;  // written when the program has ended
  std::filesystem::path trace;
};

// Adds the job to the program.
void add_options(CLI::App& app, RunOptions& options);

// A program may begin elsewhere than where the chip starts: then a jump is put there. Throws
// std::runtime_error where there is no room for it.
void make_start(const sim::ElfImage& image, sim::Chip& chip);

// Returns the exit status of the job.
int run(const RunOptions& options);

}  // namespace command
