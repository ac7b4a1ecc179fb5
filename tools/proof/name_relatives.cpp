// SPDX-License-Identifier: Apache-2.0
// By the words that names share.
#include "tools/proof/name_relatives.hpp"

#include <algorithm>
#include <set>

namespace proof {

namespace {

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words{""};
  for (const char c : name) {
    if (c == '_') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

// How many words both names begin with; where there is none, how many they end with, as a part.
double kinship(const std::string& one, const std::string& other) {
  const std::vector<std::string> a = words_of(one);
  const std::vector<std::string> b = words_of(other);
  const auto first = std::ranges::mismatch(a, b).in1 - a.begin();
  const auto last = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend()).first - a.rbegin();
  constexpr double less = 0.01;
  return first != 0 ? static_cast<double>(first) : less * static_cast<double>(last);
}

}  // namespace

NameRelatives::NameRelatives(const VhdlText& text, const std::vector<std::string>& constants) {
  std::set<std::string> names[2];
  for (const Expression& expression : text.outline().expressions) {
    for (std::size_t i = expression.tokens.first; i < expression.tokens.last; ++i) {
      if (text.is_name(i, expression.tokens)) names[text.is_field(i)].insert(text.word(i));
    }
  }
  for (const bool fields : {false, true}) {
    std::set<std::string> others = names[fields];
    if (!fields) others.insert(constants.begin(), constants.end());
    for (const std::string& name : names[fields]) {
      std::string found;
      double nearest = 0;
      for (const std::string& other : others) {
        const double near = kinship(name, other);
        if (other != name &&
            (near > nearest || (near == nearest && near > 0 && found < name && other > name))) {
          found = other;
          nearest = near;
        }
      }
      if (!found.empty()) families_[fields][name] = found;
    }
  }
}

const std::string* NameRelatives::find(const std::string& name, bool is_field) const {
  const auto found = families_[is_field].find(name);
  return found == families_[is_field].end() ? nullptr : &found->second;
}

}  // namespace proof
