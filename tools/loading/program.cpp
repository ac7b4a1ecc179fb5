// SPDX-License-Identifier: Apache-2.0
// Segments put together, with zeros between them.
#include "tools/loading/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/simulation/elf_image.hpp"

namespace loading {

namespace {

Program joined(const sim::ElfImage& image) {
  Program program{.address = loader_address, .bytes = {}, .entry = image.entry};
  std::uint32_t end = memory_address;
  for (const sim::ElfSegment& segment : image.segments) {
    const auto size = static_cast<std::uint32_t>(segment.bytes.size());
    if (size == 0 || segment.address >= loader_address) continue;
    if (segment.address < memory_address || size > loader_address - segment.address) {
      throw std::runtime_error(fmt::format(
          "{} bytes at {:#010x} are not within {:#010x} to {:#010x}, what a program may fill", size,
          segment.address, memory_address, loader_address));
    }
    program.address = std::min(program.address, segment.address);
    end = std::max(end, segment.address + size);
  }
  if (end <= program.address) throw std::runtime_error("the file holds nothing to load");
  program.bytes.resize(end - program.address);
  for (const sim::ElfSegment& segment : image.segments) {
    if (segment.address >= loader_address) continue;
    std::ranges::copy(segment.bytes, program.bytes.begin() + (segment.address - program.address));
  }
  return program;
}

}  // namespace

Program read_program(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file),
                                        std::istreambuf_iterator<char>()};
  return parse_program(bytes, path.string());
}

Program parse_program(std::span<const std::uint8_t> contents, const std::string& name) {
  constexpr std::array<std::uint8_t, 4> magic{0x7F, 'E', 'L', 'F'};
  if (contents.size() >= magic.size() && std::ranges::equal(magic, contents.first(magic.size()))) {
    return joined(sim::parse_elf(contents, name));
  }
  if (contents.empty() || contents.size() > loader_address - memory_address) {
    throw std::runtime_error(fmt::format("{} has {} bytes; a program has 1 to {}", name,
                                         contents.size(), loader_address - memory_address));
  }
  return {.address = memory_address,
          .bytes = {contents.begin(), contents.end()},
          .entry = memory_address};
}

}  // namespace loading
