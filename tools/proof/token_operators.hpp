// SPDX-License-Identifier: Apache-2.0
// The operators that change one token, or one name: logic, relation, arithmetic, number, bit, name,
// and `zero` for parts of a concatenation.
#pragma once

#include "tools/proof/mutant_draft.hpp"
#include "tools/proof/name_relatives.hpp"

namespace proof {

void mutate_tokens(const VhdlText& text, const NameRelatives& relatives,
                   const Expression& expression, MutantDraft& draft);

}  // namespace proof
