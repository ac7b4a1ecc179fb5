// SPDX-License-Identifier: Apache-2.0
// By depth of parentheses: expressions have no tree here.
#include "tools/proof/structure_operators.hpp"

#include <fmt/format.h>

namespace proof {

namespace {

// Operands of logical operators end at these, at the same depth.
bool is_boundary(const std::string& text) {
  return text == "," || text == "=>" || text == "when" || text == "else" || text == "|";
}

std::size_t operand_end(const VhdlText& text, std::size_t i, Span all) {
  for (int depth = 0; i < all.last; ++i) {
    if (text.word(i) == ")" && depth == 0) {
      break;
    }
    depth += text.word(i) == "(" ? 1 : text.word(i) == ")" ? -1 : 0;
    if (depth == 0 && (is_boundary(text.word(i)) || is_logical(text.word(i)))) break;
  }
  return i;
}

std::size_t operand_start(const VhdlText& text, std::size_t i, Span all) {
  for (int depth = 0; i > all.first; --i) {
    const std::string& before = text.word(i - 1);
    if (before == "(" && depth == 0) {
      break;
    }
    depth += before == ")" ? 1 : before == "(" ? -1 : 0;
    if (depth == 0 && (is_boundary(before) || is_logical(before))) break;
  }
  return i;
}

}  // namespace

void drop_operands(const VhdlText& text, const Expression& expression, MutantDraft& draft) {
  const Span all = expression.tokens;
  for (std::size_t i = all.first; i < all.last; ++i) {
    if (!is_logical(text.word(i)) || !text.has_operand_before(i, all)) continue;
    const std::size_t end = operand_end(text, i + 1, all);
    draft.replace("operand", {i, end}, expression.statement, {""});
    const std::size_t start = operand_start(text, i, all);
    const bool is_first = start == all.first || !is_logical(text.word(start - 1)) ||
                          !text.has_operand_before(start - 1, all);
    if (is_first) draft.replace("operand", {start, i + 1}, expression.statement, {""});
  }
}

void swap_neighbours(const VhdlText& text, const Expression& expression, MutantDraft& draft) {
  for (std::size_t i = expression.tokens.first; i < expression.tokens.last; ++i) {
    if (text.word(i) != "(") {
      continue;
    }
    const std::size_t end = text.past_parentheses(i) - 1;
    std::vector<Span> values;
    std::size_t first = i + 1;
    int depth = 0;
    for (std::size_t k = i + 1; k <= end; ++k) {
      if (depth == 0 && (text.word(k) == "," || k == end)) {
        values.push_back({first, k});
        first = k + 1;
      } else if (depth == 0 && text.word(k) == "=>") {
        first = k + 1;
      }
      depth += text.word(k) == "(" ? 1 : text.word(k) == ")" ? -1 : 0;
    }
    for (std::size_t k = 0; k + 1 < values.size(); ++k) {
      if (values[k].first >= values[k].last || values[k + 1].first >= values[k + 1].last) continue;
      const std::string between = text.source({values[k].last, values[k + 1].first});
      if (text.source(values[k]) != text.source(values[k + 1])) {
        draft.replace("swap", {values[k].first, values[k + 1].last}, expression.statement,
                      {text.source(values[k + 1]) + " " + between + " " + text.source(values[k])});
      }
    }
  }
}

void swap_arms(const VhdlText& text, MutantDraft& draft) {
  for (const std::vector<Expression>& arms : text.outline().cases) {
    for (std::size_t i = 0; i + 1 < arms.size(); ++i) {
      const Expression& one = arms[i];
      const Expression& other = arms[i + 1];
      const std::string between = text.source(other.statement);
      if (one.tokens.first == one.tokens.last || other.tokens.first == other.tokens.last ||
          text.source(one.tokens) == text.source(other.tokens)) {
        continue;
      }
      const std::string shown =
          fmt::format("{} {{<->}} {}", text.shown(one.statement), text.shown(other.statement));
      draft.replace_shown_as(
          shown, "arms", {one.tokens.first, other.tokens.last},
          {text.source(other.tokens) + "\n" + between + "\n" + text.source(one.tokens)});
    }
  }
}

}  // namespace proof
