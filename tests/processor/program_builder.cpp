// SPDX-License-Identifier: Apache-2.0
// Layout of a program of instructions of two lengths.
#include "tests/processor/program_builder.hpp"

#include <utility>

namespace processor {

void ProgramBuilder::add_distance(std::size_t from, std::size_t target, Encoder encode) {
  const unsigned bytes = (encode(0) & 3) == 3 ? 4 : 2;
  instructions_.push_back(
      {.bytes = bytes, .from = from, .target = target, .encode = std::move(encode)});
}

std::uint32_t ProgramBuilder::bytes() const {
  std::uint32_t sum = 0;
  for (const auto& instruction : instructions_) sum += instruction.bytes;
  return sum;
}

std::vector<std::uint8_t> ProgramBuilder::image() const {
  std::vector<std::int32_t> places{0};
  for (const auto& instruction : instructions_) {
    places.push_back(places.back() + static_cast<std::int32_t>(instruction.bytes));
  }
  std::vector<std::uint8_t> image;
  for (const auto& instruction : instructions_) {
    const Word bits =
        instruction.encode
            ? instruction.encode(places.at(instruction.target) - places.at(instruction.from))
            : instruction.bits;
    for (unsigned byte = 0; byte < instruction.bytes; ++byte) {
      image.push_back(static_cast<std::uint8_t>(bits >> (8 * byte)));
    }
  }
  return image;
}

}  // namespace processor
