// SPDX-License-Identifier: Apache-2.0
// A program as the boot loader takes it: one piece of memory, and where to begin.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "firmware/boot_loader/protocol.hpp"

namespace loading {

inline constexpr std::uint32_t memory_address = 0x8000'0000;
// The boot loader itself (firmware/boot_loader/boot_loader.ld), and where its stack ends, which no
// program that it loads may touch.
inline constexpr std::uint32_t loader_address =
    memory_address + CHIP_MEMORY_BYTES - boot_loader::loader_bytes;
inline constexpr std::uint32_t program_end = loader_address - boot_loader::loader_stack_bytes;

struct Program {
  std::uint32_t address{};
  std::vector<std::uint8_t> bytes;
  std::uint32_t entry{};
};

// An ELF file for the chip, or otherwise the plain contents of the memory from its begin on, which
// are also the entry. The boot loader's part of a firmware is left out. Throws std::runtime_error
// where a file is neither, or a text, or lies outside the memory.
Program read_program(const std::filesystem::path& file);
// The same of the contents of a file; `name` is for the message.
Program parse_program(std::span<const std::uint8_t> contents, const std::string& name);

}  // namespace loading
