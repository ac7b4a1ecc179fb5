// SPDX-License-Identifier: Apache-2.0
// A bare-metal program for the chip: its segments, sizes and symbols.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sim {

class Chip;

struct ElfSegment {
  std::uint32_t address{};
  std::vector<std::uint8_t> bytes;  // with the zeros that the file leaves out
};

struct ElfSizes {
  std::uint32_t text_bytes{};  // code and constants
  std::uint32_t data_bytes{};  // variables with initial values
  std::uint32_t bss_bytes{};  // variables that start as zero, without the stack
};

// Bytes of a segment that the program does not write: code or constants.
struct ElfConstants {
  std::uint32_t address{};
  std::uint32_t size_bytes{};
};

struct ElfImage {
  std::vector<ElfSegment> segments;
  ElfSizes sizes;
  std::uint32_t entry{};
  std::map<std::string, std::uint32_t> symbols;
  std::vector<ElfConstants> constants{};

  std::optional<std::uint32_t> symbol(const std::string& name) const;
};

// Throws std::runtime_error that says what is wrong with the file.
ElfImage read_elf(const std::filesystem::path& file);
// The same of the contents of a file; `name` is for the message.
ElfImage parse_elf(std::span<const std::uint8_t> contents, const std::string& name);

// Writes the program into the chip's memory. Throws std::runtime_error where it does not fit.
void load(const ElfImage& image, Chip& chip);

}  // namespace sim
