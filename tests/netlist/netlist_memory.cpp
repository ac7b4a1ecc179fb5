// SPDX-License-Identifier: Apache-2.0
// Of a model of the netlist the memory's 32 block RAMs, each of which holds one bit of every word;
// bit_locations.S shows which.
#include <Vprocessor_with_memory.h>
#include <Vprocessor_with_memory___024root.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tests/processor/chip_memory.hpp"

namespace processor {
namespace {

constexpr std::size_t word_bits = 32;

// The instances as tools/hardware/build_cell_model.sh numbers them, in no order that we know.
#define BLOCK_RAM(number) &root.processor_with_memory__DOT__block_ram_##number##__DOT__words
#define FOUR_BLOCK_RAMS(a, b, c, d) BLOCK_RAM(a), BLOCK_RAM(b), BLOCK_RAM(c), BLOCK_RAM(d)

auto block_rams(const Vprocessor_with_memory& model) {
  auto& root = *model.rootp;
  return std::array{FOUR_BLOCK_RAMS(0, 1, 2, 3),     FOUR_BLOCK_RAMS(4, 5, 6, 7),
                    FOUR_BLOCK_RAMS(8, 9, 10, 11),   FOUR_BLOCK_RAMS(12, 13, 14, 15),
                    FOUR_BLOCK_RAMS(16, 17, 18, 19), FOUR_BLOCK_RAMS(20, 21, 22, 23),
                    FOUR_BLOCK_RAMS(24, 25, 26, 27), FOUR_BLOCK_RAMS(28, 29, 30, 31)};
}

// cells/dp16kd.v: 16 bits of 16 addresses in each word, with a ninth bit of each half between.
struct Place {
  explicit Place(std::size_t address)
      : word(address / 16), bit(address % 8 + (address % 16 < 8 ? 0 : 9)) {}
  std::size_t word;
  std::size_t bit;
};

using BitPlaces = std::array<std::size_t, word_bits>;

// Which block RAM holds each bit, by the initial contents.
BitPlaces read_bit_places(const Vprocessor_with_memory& model) {
  const auto rams = block_rams(model);
  BitPlaces places{};
  for (std::size_t bit = 0; bit < word_bits; ++bit) {
    const Place place(bit);
    const auto holds_it = [place](const auto* ram) {
      return ((*ram)[place.word] >> place.bit & 1) != 0;
    };
    const auto found = std::ranges::find_if(rams, holds_it);
    if (std::ranges::count_if(rams, holds_it) != 1) {
      throw std::runtime_error("the netlist's memory is not one block RAM for each bit");
    }
    places[bit] = static_cast<std::size_t>(found - rams.begin());
  }
  return places;
}

// All models have the same, and the first to be written has its initial contents still.
const BitPlaces& bit_places(const Vprocessor_with_memory& model) {
  static const BitPlaces places = read_bit_places(model);
  return places;
}

}  // namespace

std::uint8_t read_byte(const Vprocessor_with_memory& model, std::size_t place) {
  const BitPlaces& places = bit_places(model);
  const auto rams = block_rams(model);
  const Place in_ram(place / 4);
  unsigned byte = 0;
  for (unsigned bit = 0; bit < 8; ++bit) {
    byte |= ((*rams[places[8 * (place % 4) + bit]])[in_ram.word] >> in_ram.bit & 1u) << bit;
  }
  return static_cast<std::uint8_t>(byte);
}

void write_byte(Vprocessor_with_memory& model, std::size_t place, std::uint8_t byte) {
  const BitPlaces& places = bit_places(model);
  const auto rams = block_rams(model);
  const Place in_ram(place / 4);
  for (unsigned bit = 0; bit < 8; ++bit) {
    auto& word = (*rams[places[8 * (place % 4) + bit]])[in_ram.word];
    word = (word & ~(1u << in_ram.bit)) | (byte >> bit & 1u) << in_ram.bit;
  }
}

}  // namespace processor
