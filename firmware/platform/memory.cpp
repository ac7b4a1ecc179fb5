// SPDX-License-Identifier: Apache-2.0
// Word loops with a tail of bytes: nearly all copies of the firmware are of a few words, aligned.
#include "platform/memory.hpp"

#include <cstdint>

namespace platform {
namespace {

// Objects of any type may be looked at as words.
using Word [[gnu::may_alias]] = std::uint32_t;
constexpr std::uintptr_t within_word = sizeof(Word) - 1;

bool on_word(const void* address) {
  return (reinterpret_cast<std::uintptr_t>(address) & within_word) == 0;
}

}  // namespace

void copy(void* to, const void* from, std::size_t bytes) {
  if (on_word(to) && on_word(from)) {
    auto* words = static_cast<Word*>(to);
    const auto* source = static_cast<const Word*>(from);
    for (; bytes >= sizeof(Word); bytes -= sizeof(Word)) *words++ = *source++;
    to = words;
    from = source;
  }
  auto* end = static_cast<unsigned char*>(to);
  const auto* source = static_cast<const unsigned char*>(from);
  for (; bytes != 0; --bytes) *end++ = *source++;
}

void move(void* to, const void* from, std::size_t bytes) {
  // Forwards, what is read has not been written yet wherever it goes to lower addresses.
  if (reinterpret_cast<std::uintptr_t>(to) <= reinterpret_cast<std::uintptr_t>(from)) {
    copy(to, from, bytes);
    return;
  }
  auto* end = static_cast<unsigned char*>(to) + bytes;
  const auto* source = static_cast<const unsigned char*>(from) + bytes;
  for (; bytes != 0; --bytes) *--end = *--source;
}

void fill(void* begin, unsigned char byte, std::size_t bytes) {
  if (on_word(begin)) {
    constexpr std::uint32_t in_every_byte = 0x0101'0101;
    const std::uint32_t word = byte * in_every_byte;
    auto* words = static_cast<Word*>(begin);
    for (; bytes >= sizeof(Word); bytes -= sizeof(Word)) *words++ = word;
    begin = words;
  }
  auto* end = static_cast<unsigned char*>(begin);
  for (; bytes != 0; --bytes) *end++ = byte;
}

}  // namespace platform
