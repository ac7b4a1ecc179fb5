// SPDX-License-Identifier: Apache-2.0
// Loops of four words, or four bytes, with tails of words and bytes: nearly all copies are of a few
// words, aligned. The bounds of their times are those of bytes, for the ends' places are not known.
#include "platform/memory.hpp"

#include <cstdint>

#include "units/loop_bound.hpp"

namespace platform {
namespace {

// Objects of any type may be looked at as words.
using Word [[gnu::may_alias]] = std::uint32_t;
constexpr std::uintptr_t within_word = sizeof(Word) - 1;
// In one round of a loop.
constexpr std::size_t block_words = 4, block_bytes = block_words * sizeof(Word);
constexpr std::size_t bytes_at_once = 4;
static_assert(bytes_at_once - 1 == within_word, "the tails are the same");

bool on_word(const void* address) {
  return (reinterpret_cast<std::uintptr_t>(address) & within_word) == 0;
}

// Behind the words there are at most 3 bytes. A loop of its own for them has a bound where nothing
// is known of the length, and leaves that of a known length to be counted.
using TailBound = units::LoopBound<within_word>;
// Likewise words behind the blocks.
using WordsBound = units::LoopBound<block_words - 1, 1>;

}  // namespace

void* copy(void* to, const void* from, std::size_t bytes) {
  auto* end = static_cast<unsigned char*>(to);
  const auto* source = static_cast<const unsigned char*>(from);
  if (on_word(to) && on_word(from)) {
    auto* words = static_cast<Word*>(to);
    const auto* source_words = static_cast<const Word*>(from);
    for (std::size_t count = bytes / block_bytes; count != 0; --count) {
      const Word first = source_words[0], second = source_words[1], third = source_words[2],
                 fourth = source_words[3];
      words[0] = first;
      words[1] = second;
      words[2] = third;
      words[3] = fourth;
      source_words += block_words;
      words += block_words;
    }
    WordsBound bound;
    for (std::size_t count = bytes % block_bytes / sizeof(Word); count != 0; --count) {
      bound.next();
      *words++ = *source_words++;
    }
    end = reinterpret_cast<unsigned char*>(words);
    source = reinterpret_cast<const unsigned char*>(source_words);
  } else {
    for (std::size_t count = bytes / bytes_at_once; count != 0; --count) {
      const unsigned char first = source[0], second = source[1], third = source[2],
                          fourth = source[3];
      end[0] = first;
      end[1] = second;
      end[2] = third;
      end[3] = fourth;
      source += bytes_at_once;
      end += bytes_at_once;
    }
  }
  TailBound bound;
  for (bytes &= within_word; bytes != 0; --bytes) {
    bound.next();
    *end++ = *source++;
  }
  return to;
}

void* move(void* to, const void* from, std::size_t bytes) {
  // Forwards, what is read has not been written yet wherever it goes to lower addresses.
  if (reinterpret_cast<std::uintptr_t>(to) <= reinterpret_cast<std::uintptr_t>(from)) {
    return copy(to, from, bytes);
  }
  auto* end = static_cast<unsigned char*>(to) + bytes;
  const auto* source = static_cast<const unsigned char*>(from) + bytes;
  for (std::size_t count = bytes / bytes_at_once; count != 0; --count) {
    source -= bytes_at_once;
    end -= bytes_at_once;
    // The ends may be one byte from each other.
    const unsigned char first = source[0], second = source[1], third = source[2],
                        fourth = source[3];
    end[3] = fourth;
    end[2] = third;
    end[1] = second;
    end[0] = first;
  }
  TailBound bound;
  for (bytes &= within_word; bytes != 0; --bytes) {
    bound.next();
    *--end = *--source;
  }
  return to;
}

void* fill(void* begin, unsigned char byte, std::size_t bytes) {
  auto* end = static_cast<unsigned char*>(begin);
  if (on_word(begin)) {
    constexpr std::uint32_t in_every_byte = 0x0101'0101;
    const std::uint32_t word = byte * in_every_byte;
    auto* words = static_cast<Word*>(begin);
    for (std::size_t count = bytes / block_bytes; count != 0; --count) {
      words[0] = word;
      words[1] = word;
      words[2] = word;
      words[3] = word;
      words += block_words;
    }
    WordsBound bound;
    for (std::size_t count = bytes % block_bytes / sizeof(Word); count != 0; --count) {
      bound.next();
      *words++ = word;
    }
    end = reinterpret_cast<unsigned char*>(words);
  } else {
    for (std::size_t count = bytes / bytes_at_once; count != 0; --count) {
      end[0] = byte;
      end[1] = byte;
      end[2] = byte;
      end[3] = byte;
      end += bytes_at_once;
    }
  }
  TailBound bound;
  for (bytes &= within_word; bytes != 0; --bytes) {
    bound.next();
    *end++ = byte;
  }
  return begin;
}

}  // namespace platform
