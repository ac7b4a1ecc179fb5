// SPDX-License-Identifier: Apache-2.0
// The operators that leave out or exchange parts: operand, swap, arms.
#pragma once

#include "tools/proof/mutant_draft.hpp"

namespace proof {

// One operand of a chain of and, or, xor left out.
void drop_operands(const VhdlText& text, const Expression& expression, MutantDraft& draft);

// Neighbours in lists of arguments and associations.
void swap_neighbours(const VhdlText& text, const Expression& expression, MutantDraft& draft);

// The statements of neighbouring arms of every case of the text.
void swap_arms(const VhdlText& text, MutantDraft& draft);

}  // namespace proof
