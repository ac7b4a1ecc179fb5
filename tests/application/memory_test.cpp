// SPDX-License-Identifier: Apache-2.0
// The image's copying and filling against the host's, at every alignment, and nothing outside.
#include "platform/memory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace {

constexpr std::size_t largest = 40, room = 64;
using Bytes = std::array<unsigned char, room>;

Bytes numbered() {
  Bytes bytes{};
  for (std::size_t i = 0; i < room; ++i) bytes[i] = static_cast<unsigned char>(i * 37 + 11);
  return bytes;
}

TEST(memory, is_copied_at_every_alignment_and_length) {
  alignas(8) const Bytes source = numbered();
  for (std::size_t from = 0; from < 8; ++from) {
    for (std::size_t to = 0; to < 8; ++to) {
      for (std::size_t bytes = 0; bytes <= largest; ++bytes) {
        alignas(8) Bytes expected{}, copied{};
        std::memcpy(expected.data() + to, source.data() + from, bytes);
        platform::copy(copied.data() + to, source.data() + from, bytes);
        ASSERT_EQ(copied, expected) << bytes << " bytes from " << from << " to " << to;
      }
    }
  }
}

TEST(memory, is_moved_within_itself_either_way) {
  for (std::size_t from = 0; from < 24; ++from) {
    for (std::size_t to = 0; to < 24; ++to) {
      for (std::size_t bytes = 0; bytes <= largest; ++bytes) {
        alignas(8) Bytes expected = numbered(), moved = numbered();
        std::memmove(expected.data() + to, expected.data() + from, bytes);
        platform::move(moved.data() + to, moved.data() + from, bytes);
        ASSERT_EQ(moved, expected) << bytes << " bytes from " << from << " to " << to;
      }
    }
  }
}

TEST(memory, is_filled_at_every_alignment_and_length) {
  for (const int byte : {0, 1, 0x80, 0xFF}) {
    for (std::size_t begin = 0; begin < 8; ++begin) {
      for (std::size_t bytes = 0; bytes <= largest; ++bytes) {
        alignas(8) Bytes expected = numbered(), filled = numbered();
        std::memset(expected.data() + begin, byte, bytes);
        platform::fill(filled.data() + begin, static_cast<unsigned char>(byte), bytes);
        ASSERT_EQ(filled, expected) << bytes << " bytes of " << byte << " at " << begin;
      }
    }
  }
}

}  // namespace
