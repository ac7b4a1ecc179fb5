// SPDX-License-Identifier: Apache-2.0
// The Verilated processor with its memory, clocked by a test; a TestDevice answers on the bus.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tests/processor/test_device.hpp"

class VerilatedContext;
class Vprocessor_with_memory;

namespace processor {

// A retired instruction, or a trap, and its clock.
struct Retirement {
  std::uint64_t clock = 0;
  bool trap = false;
  bool interrupt = false;
  std::uint32_t address = 0;
  std::uint32_t instruction = 0;
  unsigned destination = 0;
  std::uint32_t value = 0;
};

std::vector<std::uint8_t> read_image(const std::filesystem::path& path);

class Chip {
 public:
  static constexpr std::uint32_t memory_base = 0x80000000;
  static constexpr std::size_t memory_size = 65536;
  // Whether this processor implements Zbb.
  static const bool has_zbb;

  // Starts after reset with the image at the start of the memory and zeros after it.
  explicit Chip(const std::vector<std::uint8_t>& image);
  ~Chip();
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;

  // One clock; what the processor completed in it.
  std::optional<Retirement> clock();
  // Clocks until something is completed or refused; nothing if that takes more than `limit` clocks.
  std::optional<Retirement> next_retirement(unsigned limit = 200);

  std::uint64_t clocks() const { return clocks_; }
  bool sleeping() const;
  std::uint32_t word(std::uint32_t address) const;
  std::vector<std::uint8_t> memory() const;
  TestDevice& device() { return device_; }
  // Clocks from the start of a bus request to its response; 1 as the chip's peripherals.
  void set_bus_wait(unsigned clocks) { bus_wait_ = clocks; }

 private:
  void answer_bus();

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vprocessor_with_memory> model_;
  TestDevice device_;
  std::uint64_t clocks_ = 0;
  unsigned bus_wait_ = 1;
  unsigned bus_waited_ = 0;
};

}  // namespace processor
