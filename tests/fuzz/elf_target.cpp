// SPDX-License-Identifier: Apache-2.0
// ELF files as `run`, `debug` and `load` take them: each is refused with a sentence, or its bytes
// are those in the chip's memory, and of the program that goes over the serial line.
#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/simulation/chip.hpp"
#include "sim/simulation/elf_image.hpp"
#include "tests/fuzz/property.hpp"
#include "tools/loading/program.hpp"

namespace {

constexpr std::uint32_t memory_address = 0x8000'0000;
constexpr std::uint32_t memory_bytes = 8 * 1024;
// The largest that the design allows, many times over.
constexpr std::size_t most_bytes = std::size_t{1} << 24;

class Memory : public sim::Chip {
 public:
  void advance(sim::Clock) override {}
  void reset() override {}
  std::uint32_t read_memory(std::uint32_t address) const override { return words_[place(address)]; }
  void write_memory(std::uint32_t address, std::uint32_t word) override {
    words_[place(address)] = word;
  }
  sim::QueueStatistics queue_statistics() const override { return {}; }
  sim::ProcessorStatistics processor_statistics() const override { return {}; }
  void trace_to(const std::string&) override {}

  std::uint8_t byte(std::uint32_t address) const {
    return static_cast<std::uint8_t>(read_memory(address & ~3U) >> 8 * (address & 3));
  }

 private:
  static std::size_t place(std::uint32_t address) {
    if (address < memory_address || address - memory_address >= memory_bytes || address % 4 != 0) {
      throw std::out_of_range("outside the memory");
    }
    return (address - memory_address) / 4;
  }
  std::vector<std::uint32_t> words_ = std::vector<std::uint32_t>(memory_bytes / 4, 0xEEEEEEEE);
};

// Whether a later segment, which counts, has this place too.
bool is_covered(const sim::ElfImage& image, std::size_t segment, std::uint64_t address) {
  for (std::size_t i = segment + 1; i < image.segments.size(); ++i) {
    const sim::ElfSegment& other = image.segments[i];
    if (address >= other.address && address - other.address < other.bytes.size()) return true;
  }
  return false;
}

template <class ByteAt>
void require_bytes(const sim::ElfImage& image, std::uint64_t end, ByteAt byte_at) {
  for (std::size_t segment = 0; segment < image.segments.size(); ++segment) {
    const auto& [address, bytes] = image.segments[segment];
    if (address >= end) continue;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (is_covered(image, segment, std::uint64_t{address} + i)) continue;
      fuzz::require(byte_at(address + static_cast<std::uint32_t>(i)) == bytes[i],
                    "byte {} of the segment at {:#x} is another in memory", i, address);
    }
  }
}

void require_in_memory(const sim::ElfImage& image) {
  Memory memory;
  try {
    sim::load(image, memory);
  } catch (const std::runtime_error&) {
    return;
  }
  require_bytes(image, std::uint64_t{1} << 32,
                [&memory](std::uint32_t address) { return memory.byte(address); });
}

void require_loadable(std::span<const std::uint8_t> contents, const sim::ElfImage& image) {
  try {
    const loading::Program program = loading::parse_program(contents, "program.elf");
    const std::uint64_t end = program.address + program.bytes.size();
    fuzz::require(!program.bytes.empty() && program.address >= loading::memory_address &&
                      end <= loading::program_end,
                  "{} bytes at {:#x} are to be loaded", program.bytes.size(), program.address);
    require_bytes(image, loading::loader_address, [&program](std::uint32_t address) {
      return program.bytes.at(address - program.address);
    });
  } catch (const std::runtime_error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span contents(data, size);
  try {
    const sim::ElfImage image = sim::parse_elf(contents, "program.elf");
    std::size_t bytes = 0;
    for (const sim::ElfSegment& segment : image.segments) {
      bytes += segment.bytes.size();
      fuzz::require(std::uint64_t{segment.address} + segment.bytes.size() <= std::uint64_t{1} << 32,
                    "a segment goes beyond the address space");
    }
    fuzz::require(bytes <= most_bytes, "{} bytes of memory for a file of {}", bytes, size);
    require_in_memory(image);
    require_loadable(contents, image);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
