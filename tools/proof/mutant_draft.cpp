// SPDX-License-Identifier: Apache-2.0
// The id: file, operator and the changed text within its statement.
#include "tools/proof/mutant_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace proof {

namespace {

std::string trimmed(std::string text) {
  const std::size_t first = text.find_first_not_of(' ');
  const std::size_t last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// Line breaks and the like are no part of an id.
std::string shown_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\n';
    if (!is_blank || (!result.empty() && result.back() != ' ')) result += is_blank ? ' ' : c;
  }
  return trimmed(result);
}

}  // namespace

void MutantDraft::replace_shown_as(const std::string& shown, const char* kind, Span span,
                                   std::vector<std::string> texts) {
  Mutant mutant;
  mutant.id = fmt::format("{}: {}: {}", stem_, kind, trimmed(shown));
  mutant.kind = kind;
  mutant.begin = text_.token(span.first).begin;
  mutant.end = text_.token(span.last - 1).end;
  mutant.texts = std::move(texts);
  mutants_.push_back(std::move(mutant));
}

void MutantDraft::replace(const char* kind, Span span, Span statement,
                          std::vector<std::string> texts) {
  constexpr std::size_t shown_context = 60;
  std::string before = text_.shown({statement.first, span.first});
  std::string after = text_.shown({span.last, std::max(span.last, statement.last)});
  if (before.size() > shown_context) before = "..." + before.substr(before.size() - shown_context);
  if (after.size() > shown_context) after = after.substr(0, shown_context) + "...";
  const std::string operation = kind;
  const std::string what = text_.shown(span);
  std::string shown;
  if (operation == "drop") {
    shown = what;
  } else if (operation == "negate") {
    shown = fmt::format("{} {{not ({})}} {}", before, what, after);
  } else if (operation == "zero") {
    shown = fmt::format("{} {{0 for {}}} {}", before, what, after);
  } else {
    shown = fmt::format("{} {{{} -> {}}} {}", before, what, shown_text(texts.front()), after);
  }
  replace_shown_as(shown, kind, span, std::move(texts));
}

std::vector<Mutant> MutantDraft::finish() {
  std::map<std::string, int> seen;
  for (Mutant& mutant : mutants_) {
    const int count = ++seen[mutant.id];
    if (count > 1) mutant.id += fmt::format(" #{}", count);
  }
  return std::move(mutants_);
}

}  // namespace proof
