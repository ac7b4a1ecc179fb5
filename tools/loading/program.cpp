// SPDX-License-Identifier: Apache-2.0
// Segments put together, with zeros between them.
#include "tools/loading/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
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
    if (segment.address < memory_address || segment.address >= program_end ||
        size > program_end - segment.address) {
      throw std::runtime_error(fmt::format(
          "{} bytes at {:#010x} are not within {:#010x} to {:#010x}, what a program may fill", size,
          segment.address, memory_address, program_end));
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

// Most of an ELF file is for the debugger. A device file may be endless.
constexpr std::size_t most_file_bytes = std::size_t{64} << 20;

// Instructions have zeros and control characters among them, G-code and other texts have none,
// whatever the encoding of their comments.
bool is_text(std::span<const std::uint8_t> contents) {
  return std::ranges::none_of(contents, [](std::uint8_t byte) {
    return (byte < ' ' && (byte < '\t' || byte > '\r')) || byte == 0x7F;
  });
}

}  // namespace

Program read_program(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes;
  std::array<char, 65'536> buffer;
  while (file && bytes.size() <= most_file_bytes) {
    file.read(buffer.data(), buffer.size());
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + file.gcount());
  }
  if (!file.eof() && bytes.size() <= most_file_bytes) {
    throw std::runtime_error("cannot read " + path.string());
  }
  if (bytes.size() > most_file_bytes) {
    throw std::runtime_error(fmt::format("{} has more than {} bytes: no program for the chip",
                                         path.string(), most_file_bytes));
  }
  return parse_program(bytes, path.string());
}

Program parse_program(std::span<const std::uint8_t> contents, const std::string& name) {
  constexpr std::array<std::uint8_t, 4> magic{0x7F, 'E', 'L', 'F'};
  if (contents.size() >= magic.size() && std::ranges::equal(magic, contents.first(magic.size()))) {
    return joined(sim::parse_elf(contents, name));
  }
  if (contents.empty() || contents.size() > program_end - memory_address) {
    throw std::runtime_error(fmt::format("{} has {} bytes; a program has 1 to {}", name,
                                         contents.size(), program_end - memory_address));
  }
  if (is_text(contents)) {
    throw std::runtime_error(
        name +
        " is text, no program: `load` takes an ELF file or the plain contents of the memory. "
        "G-code is printed with `stepfabric print`, or by a host program at the port");
  }
  return {.address = memory_address,
          .bytes = {contents.begin(), contents.end()},
          .entry = memory_address};
}

}  // namespace loading
