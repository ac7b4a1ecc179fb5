// SPDX-License-Identifier: Apache-2.0
// The places in a VHDL file where something is computed: not a full parser, it finds where
// statements begin and end.
#pragma once

#include <vector>

#include "tools/proof/vhdl_tokens.hpp"

namespace proof {

// Tokens `first` up to `last`, which is not part of it.
struct Span {
  std::size_t first{};
  std::size_t last{};
};

struct Expression {
  Span tokens;
  Span statement;  // what it is shown in: a statement, or the head of one
};

struct Outline {
  std::vector<Expression>
      expressions;  // values, conditions, indices of targets; they do not overlap
  std::vector<Expression>
      conditions;  // parts of `expressions`: of if, elsif, while, when, exit, next
  std::vector<Expression> values;  // parts of `expressions`: what is assigned or returned
  std::vector<Span> removable;  // assignments and calls in sequence, with their `;`
  std::vector<std::vector<Expression>> cases;  // of each case statement the statements of each arm
};

// Declarations, initial values of signals and of the variables of processes, entities, assertions
// and waits are left out; constants and the variables of subprograms are in. Throws
// std::runtime_error if the file is not in the supported subset.
Outline outline_of(const std::vector<Token>& tokens);

}  // namespace proof
