// SPDX-License-Identifier: Apache-2.0
// Every operator on every place of the outline; here those of whole conditions, values, statements.
#include "tools/proof/mutants.hpp"

#include <fmt/format.h>

#include "tools/proof/mutant_draft.hpp"
#include "tools/proof/structure_operators.hpp"
#include "tools/proof/token_operators.hpp"

namespace proof {

namespace {

std::vector<std::string> zeros(const std::string& value) {
  return {fmt::format("({0}) xor ({0})", value), fmt::format("({0}) - ({0})", value)};
}

void mutate_statements(const VhdlText& text, MutantDraft& draft) {
  for (const Expression& condition : text.outline().conditions) {
    if (!text.is_one_relation(condition.tokens)) {  // there `relation` does the same
      draft.replace("negate", condition.tokens, condition.statement,
                    {fmt::format("not ({})", text.source(condition.tokens))});
    }
  }
  for (const Span& statement : text.outline().removable) {
    draft.replace("drop", statement, statement, {"null;"});
  }
  for (const Expression& value : text.outline().values) {
    if (!text.is_literal(value.tokens)) {
      draft.replace("zero", value.tokens, value.statement, zeros(text.source(value.tokens)));
    }
  }
}

}  // namespace

std::vector<Mutant> mutants_of(std::string_view text, const std::string& stem,
                               const std::vector<std::string>& constants) {
  const VhdlText vhdl(text);
  const NameRelatives relatives(vhdl, constants);
  MutantDraft draft(vhdl, stem);
  mutate_statements(vhdl, draft);
  swap_arms(vhdl, draft);
  for (const Expression& expression : vhdl.outline().expressions) {
    mutate_tokens(vhdl, relatives, expression, draft);
    drop_operands(vhdl, expression, draft);
    swap_neighbours(vhdl, expression, draft);
  }
  return draft.finish();
}

std::vector<std::string> constants_of(std::string_view text) {
  std::vector<std::string> names;
  const std::vector<Token> tokens = tokens_of(text);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text == "constant") names.push_back(tokens[i + 1].text);
  }
  return names;
}

std::string with_mutant(std::string_view text, const Mutant& mutant, std::size_t choice) {
  return fmt::format("{}{}{}", text.substr(0, mutant.begin), mutant.texts.at(choice),
                     text.substr(mutant.end));
}

}  // namespace proof
