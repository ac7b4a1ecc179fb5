// SPDX-License-Identifier: Apache-2.0
// What a program leaves in memory for comparison with a reference, as the RISC-V architecture tests
// have it.
#pragma once

#include <cstdint>
#include <filesystem>

namespace sim {
class Chip;
struct ElfImage;
}  // namespace sim

namespace command {

// The words from the symbol `begin_signature` up to `end_signature`.
struct Signature {
  std::uint32_t begin{};
  std::uint32_t end{};
};

// Throws std::runtime_error where a symbol is missing, or both do not enclose whole words of the
// chip's memory.
Signature find_signature(const sim::ElfImage& image, const sim::Chip& chip);

// A word to a line, eight hexadecimal digits. Throws std::runtime_error where the file
// cannot be written.
void write_signature(const Signature& signature, const sim::Chip& chip,
                     const std::filesystem::path& file);

}  // namespace command
