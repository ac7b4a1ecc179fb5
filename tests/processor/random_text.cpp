// SPDX-License-Identifier: Apache-2.0
// Choices for random instructions.
#include "tests/processor/random_text.hpp"

#include <array>

namespace processor {

using encode::Word;

Word RandomText::interesting_value() {
  constexpr std::array<Word, 8> values{0,          1,          0xFFFFFFFF, 0x80000000,
                                       0x7FFFFFFF, 0x55555555, 0xFFFF,     2};
  return one_in(2) ? values[below(values.size())] : any_word();
}

bool RandomText::may_be_written(Word index) {
  return index < random_registers::handler && index != random_registers::stack_pointer &&
         index != random_registers::short_data_base;
}

Word RandomText::destination() {
  while (true) {
    const Word index = below(random_registers::handler);
    if (may_be_written(index)) return index;
  }
}

std::size_t RandomText::target_ahead() {
  const std::size_t target = program.size() + 1 + below(8);
  add_target(target);
  return target;
}

bool RandomText::is_target(std::size_t first, std::size_t last) const {
  const auto found = targets_.lower_bound(first);
  return found != targets_.end() && *found <= last;
}

}  // namespace processor
