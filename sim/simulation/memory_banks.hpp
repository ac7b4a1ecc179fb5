// SPDX-License-Identifier: Apache-2.0
// The memory of a Verilated chip (rtl/memory/memory.vhd): banks that follow one another, each
// with a lane for each byte of a word.
#pragma once

#include <cstdint>

namespace sim {

// The byte at this word's place in a lane of the memory, which is so many arrays of the model; null
// beyond their end.
template <typename First, typename... Others>
auto* byte_in_banks(std::uint32_t word, First& first, Others&... others) {
  constexpr std::uint32_t words = sizeof(First);
  using Byte = decltype(&first[0]);
  if (word < words) return &first[word];
  if constexpr (sizeof...(Others) > 0) {
    return byte_in_banks(word - words, others...);
  } else {
    return Byte{};
  }
}

}  // namespace sim
