// SPDX-License-Identifier: Apache-2.0
// Puts long and short instructions one after the other and fills in the distances of jumps.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim/processor/encode.hpp"

namespace processor {

class ProgramBuilder {
 public:
  using Word = encode::Word;
  // The instruction that bridges so many bytes.
  using Encoder = std::function<Word(std::int32_t)>;

  void add_long(Word word) { instructions_.push_back({.bits = word, .bytes = 4}); }
  void add_short(Word half_word) { instructions_.push_back({.bits = half_word, .bytes = 2}); }
  // As long as its lowest bits say.
  void add(Word bits) { (bits & 3) == 3 ? add_long(bits) : add_short(bits); }
  // Its distance leads from instruction `from` to instruction `target`, which may come later.
  void add_distance(std::size_t from, std::size_t target, Encoder encode);
  // Instructions so far.
  std::size_t size() const { return instructions_.size(); }
  // Bytes so far.
  std::uint32_t bytes() const;
  std::vector<std::uint8_t> image() const;

 private:
  struct Instruction {
    Word bits = 0;
    unsigned bytes = 4;
    std::size_t from = 0;
    std::size_t target = 0;
    Encoder encode = {};
  };

  std::vector<Instruction> instructions_;
};

}  // namespace processor
