// SPDX-License-Identifier: Apache-2.0
// Which part of the firmware its clocks go to, from samples of the program counter.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace benchmarks {

// Shares of all samples, by part of a line's way: `line` (bytes in and out, numbers, checksums),
// `parse`, `execute`, `plan`, `hand over` (segments into the step generator), `heat`, `loop` and
// `library` (memory and division, called from anywhere). Inlined code counts where it comes from.
// Throws std::runtime_error where the program's debugging information cannot be read.
std::map<std::string, double> clock_parts(const std::map<std::uint32_t, std::uint64_t>& samples,
                                          const std::filesystem::path& program);

}  // namespace benchmarks
