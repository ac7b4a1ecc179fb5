// SPDX-License-Identifier: Apache-2.0
// Compares the chip's memory with the block RAM of the devices.
#include "tools/synthesis/obstacles.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "tools/synthesis/device.hpp"
#include "tools/synthesis/job.hpp"
#include "tools/synthesis/quartus.hpp"

namespace synthesis {
namespace {

constexpr std::uint32_t kib = 1024;
// memory_kib is a multiple of it (tools/machine_generator).
constexpr std::uint32_t memory_step = 4 * kib;
// Of boards/cyclone/memory.v.
constexpr int most_banks = 3;
constexpr std::array boards_with_cyclone{"de2_115", "de2_70"};

std::string choice_of(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, " or "));
}

// The chip's queues take block RAM too: where the memory takes all of it, nothing is left for them.
std::string obstacle_of_ecp5(const Options& options) {
  const Device& device = device_named(options.device);
  const std::uint32_t needed = options.memory_bytes / ecp5_block_bytes;
  if (device.family != Family::ecp5 || needed < device.block_rams) return {};
  std::vector<std::string> others;
  for (const Device& other : devices) {
    if (other.family != device.family || other.block_rams <= needed) continue;
    others.emplace_back(other.name);
  }
  return fmt::format("{} KiB of memory are {} block RAMs, and a {} has {}: choose {}",
                     options.memory_bytes / kib, needed, device.name, device.block_rams,
                     others.empty() ? "a smaller memory_kib" : "--device " + choice_of(others));
}

bool has_room(const std::filesystem::path& board_folder, std::uint32_t memory_bytes) {
  const auto properties = board_properties(board_folder);
  return memory_bytes * 8ULL <
         std::stoull(properties.at("block_rams")) * std::stoull(properties.at("block_ram_bits"));
}

std::string obstacle_of_cyclone(const Options& options, const std::filesystem::path& project) {
  const std::uint32_t bytes = options.memory_bytes;
  if (std::popcount(bytes) > most_banks) {
    std::uint32_t larger = bytes;
    while (std::popcount(larger) > most_banks) larger += memory_step;
    return fmt::format(
        "{} KiB of memory would be more than {} banks, whose sizes are powers of two: choose "
        "memory_kib = {}",
        bytes / kib, most_banks, larger / kib);
  }
  const std::filesystem::path boards = project / "boards";
  if (has_room(boards / options.board, bytes)) return {};
  std::vector<std::string> others;
  for (const char* other : boards_with_cyclone) {
    if (has_cyclone(project, other) && has_room(boards / other, bytes)) others.emplace_back(other);
  }
  others.emplace_back("ulx3s");
  const auto properties = board_properties(boards / options.board);
  return fmt::format(
      "{} KiB of memory are all block RAM of the {} or more ({} blocks of {} bits): choose {}, or "
      "a smaller memory_kib",
      bytes / kib, properties.at("device"), properties.at("block_rams"),
      properties.at("block_ram_bits"), choice_of(others));
}

}  // namespace

std::string obstacle_to(const Options& options, const std::filesystem::path& project) {
  // The processor alone has memory of a size of its own; a synthesis that is there has had room.
  if (options.board == "core" || options.firmware_only) return {};
  return has_cyclone(project, options.board) ? obstacle_of_cyclone(options, project)
                                             : obstacle_of_ecp5(options);
}

}  // namespace synthesis
