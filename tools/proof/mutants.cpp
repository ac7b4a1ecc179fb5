// SPDX-License-Identifier: Apache-2.0
// Each operator looks at the expressions and statements of the outline.
#include "tools/proof/mutants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "tools/proof/vhdl_outline.hpp"

namespace proof {

namespace {

using Kind = Token::Kind;

class Generator {
 public:
  Generator(std::string_view text, std::string stem, const std::vector<std::string>& constants)
      : text_(text),
        stem_(std::move(stem)),
        constants_(constants),
        tokens_(tokens_of(text)),
        outline_(outline_of(tokens_)) {}

  std::vector<Mutant> generate() {
    for (const Expression& condition : outline_.conditions) {
      if (is_one_relation(condition.tokens)) {
        continue;  // `relation` does the same
      }
      replace("negate", condition.tokens, condition.statement,
              {fmt::format("not ({})", source(condition.tokens))});
    }
    for (const Span& statement : outline_.removable) {
      replace("drop", statement, statement, {"null;"});
    }
    for (const Expression& value : outline_.values) {
      if (!is_literal(value.tokens)) {
        replace("zero", value.tokens, value.statement, zeros(value.tokens));
      }
    }
    swap_arms();
    collect_names();
    for (const Expression& expression : outline_.expressions) {
      mutate_tokens(expression);
      drop_operands(expression);
      mutate_lists(expression);
    }
    number_equal_ids();
    return std::move(mutants_);
  }

 private:
  const std::string& word(std::size_t i) const { return tokens_[i].text; }
  std::string source(Span span) const {
    if (span.first >= span.last) {
      return {};
    }
    const std::size_t begin = tokens_[span.first].begin;
    return std::string(text_.substr(begin, tokens_[span.last - 1].end - begin));
  }

  // The tokens with single blanks.
  std::string shown(Span span) const {
    std::string result;
    for (std::size_t i = span.first; i < span.last; ++i) {
      const std::string& text = word(i);
      const bool is_tight = result.empty() || text == ")" || text == "," || text == "." ||
                            text == ";" || text == "'" || result.back() == '.' ||
                            result.back() == '(' || (result.back() == '\'' && word(i - 1) == "'") ||
                            (text == "(" && i > span.first && tokens_[i - 1].kind == Kind::word &&
                             !is_reserved(word(i - 1)));
      result += (is_tight ? "" : " ") + text;
    }
    return result;
  }

  void replace(const char* kind, Span span, Span statement, std::vector<std::string> texts) {
    constexpr std::size_t shown_context = 60;
    std::string before = shown({statement.first, span.first});
    std::string after = shown({span.last, std::max(span.last, statement.last)});
    if (before.size() > shown_context) {
      before = "..." + before.substr(before.size() - shown_context);
    }
    if (after.size() > shown_context) {
      after = after.substr(0, shown_context) + "...";
    }
    Mutant mutant;
    mutant.kind = kind;
    mutant.begin = tokens_[span.first].begin;
    mutant.end = tokens_[span.last - 1].end;
    mutant.texts = std::move(texts);
    std::string what;
    if (mutant.kind == "drop") {
      what = shown(span);
    } else if (mutant.kind == "negate") {
      what = fmt::format("{} {{not ({})}} {}", before, shown(span), after);
    } else if (mutant.kind == "zero") {
      what = fmt::format("{} {{0 for {}}} {}", before, shown(span), after);
    } else {
      std::string to = shown_text(mutant.texts.front());
      what = fmt::format("{} {{{} -> {}}} {}", before, shown(span), to, after);
    }
    mutant.id = fmt::format("{}: {}: {}", stem_, kind, trimmed(what));
    mutants_.push_back(std::move(mutant));
  }

  bool is_one_relation(Span span) const {
    int relations = 0;
    for (std::size_t i = span.first; i < span.last; ++i) {
      relations += word(i) == "=" || word(i) == "/=" ? 1 : 0;
      if (is_logical(word(i)) || word(i) == "not") {
        return false;
      }
    }
    return relations == 1;
  }

  static std::string trimmed(std::string text) {
    const std::size_t first = text.find_first_not_of(' ');
    const std::size_t last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
  }
  // Line breaks and the like are no part of an id.
  static std::string shown_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
      const bool is_blank = c == ' ' || c == '\n';
      if (!is_blank || (!result.empty() && result.back() != ' ')) {
        result += is_blank ? ' ' : c;
      }
    }
    return trimmed(result);
  }

  bool is_literal(Span span) const {
    if (span.first + 1 == span.last) {
      return tokens_[span.first].kind != Kind::word;
    }
    return word(span.first) == "(" && word(span.first + 1) == "others" &&
           span.last - span.first <= 7;
  }

  std::vector<std::string> zeros(Span span) const {
    const std::string value = source(span);
    return {fmt::format("({0}) xor ({0})", value), fmt::format("({0}) - ({0})", value)};
  }

  void mutate_token(std::size_t i, Span statement, const char* kind, const std::string& to) {
    replace(kind, {i, i + 1}, statement, {to});
  }

  void mutate_tokens(const Expression& expression) {
    for (std::size_t i = expression.tokens.first; i < expression.tokens.last; ++i) {
      const Token& token = tokens_[i];
      switch (token.kind) {
        case Kind::word:
          mutate_word(i, expression);
          break;
        case Kind::symbol:
          mutate_symbol(i, expression);
          break;
        case Kind::character:
          // Compared with the other value is what `relation` does.
          if ((token.text == "'0'" || token.text == "'1'") && i > 0 && word(i - 1) != "=" &&
              word(i - 1) != "/=") {
            mutate_token(i, expression.statement, "bit", token.text == "'0'" ? "'1'" : "'0'");
          }
          break;
        case Kind::string:
          mutate_string(i, expression);
          break;
        case Kind::number:
          mutate_number(i, expression);
          break;
      }
    }
  }

  void mutate_word(std::size_t i, const Expression& expression) {
    static const std::map<std::string, std::string> others{
        {"and", "or"}, {"or", "and"}, {"xor", "xnor"}, {"nand", "and"}, {"nor", "or"}};
    const auto other = others.find(word(i));
    if (other != others.end()) {
      mutate_token(i, expression.statement, "logic", other->second);
    } else if (word(i) == "not") {
      mutate_token(i, expression.statement, "logic", "");
    } else if (is_name(i, expression.tokens)) {
      const auto& family = families_[is_field(i)];
      const auto found = family.find(word(i));
      if (found != family.end()) {
        mutate_token(i, expression.statement, "name", found->second);
      }
    }
  }

  bool has_operand_before(std::size_t i, Span span) const {
    return i > span.first && word(i - 1) != "(" && word(i - 1) != "," && word(i - 1) != "=>" &&
           !(tokens_[i - 1].kind == Kind::word && is_reserved(word(i - 1)));
  }

  void mutate_symbol(std::size_t i, const Expression& expression) {
    static const std::map<std::string, std::vector<const char*>> relations{
        {"=", {"/="}},      {"/=", {"="}},       {"<", {"<=", ">="}},
        {"<=", {"<", ">"}}, {">", {">=", "<="}}, {">=", {">", "<"}}};
    static const std::map<std::string, const char*> arithmetic{{"+", "-"}, {"-", "+"}, {"*", "+"}};
    if (const auto found = relations.find(word(i)); found != relations.end()) {
      for (const char* to : found->second) {
        mutate_token(i, expression.statement, "relation", to);
      }
      // Bits have no order that anyone means.
      if (word(i) == "=" && i + 1 < expression.tokens.last &&
          tokens_[i + 1].kind != Kind::character) {
        mutate_token(i, expression.statement, "relation", ">=");
        mutate_token(i, expression.statement, "relation", "<=");
      }
    } else if (const auto sign = arithmetic.find(word(i));
               sign != arithmetic.end() && has_operand_before(i, expression.tokens)) {
      mutate_token(i, expression.statement, "arithmetic", sign->second);
    } else if (word(i) == "&") {
      zero_parts(i, expression);
    }
  }

  // The name that begins at a token, with fields, indices and attributes; nothing where more
  // follows.
  std::optional<Span> name_from(std::size_t i, Span within) const {
    const std::size_t first = i;
    if (tokens_[i].kind != Kind::word || is_reserved(word(i))) {
      return std::nullopt;
    }
    for (++i; i < within.last;) {
      if (word(i) == "." && i + 1 < within.last) {
        i += 2;
      } else if (word(i) == "(") {
        i = past_parentheses(i);
      } else {
        break;
      }
    }
    return Span{first, i};
  }

  std::size_t past_parentheses(std::size_t i) const {
    int depth = 0;
    do {
      depth += word(i) == "(" ? 1 : word(i) == ")" ? -1 : 0;
      ++i;
    } while (depth > 0 && i < tokens_.size());
    return i;
  }

  // The name behind a `&`; the first one of a chain where it is a name alone.
  void zero_parts(std::size_t i, const Expression& expression) {
    if (const auto name = name_from(i + 1, expression.tokens)) {
      zero_part(*name, expression);
    }
    if (i > expression.tokens.first && tokens_[i - 1].kind == Kind::word &&
        (i - 1 == expression.tokens.first || word(i - 2) == "(" || word(i - 2) == ",") &&
        !is_reserved(word(i - 1))) {
      zero_part({i - 1, i}, expression);
    }
  }
  void zero_part(Span name, const Expression& expression) {
    const std::string value = source(name);
    replace("zero", name, expression.statement, {fmt::format("({0} xor {0})", value)});
  }

  void mutate_string(std::size_t i, const Expression& expression) {
    std::string text = word(i);
    char& last = text[text.size() - 2];
    if (last == '0' || last == '1') {
      last = last == '0' ? '1' : '0';
      mutate_token(i, expression.statement, "bit", text);
    }
  }

  static std::optional<long> number(const std::string& text) {
    if (text.size() > 9 ||
        !std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; })) {
      return std::nullopt;
    }
    return std::stol(text);
  }

  void mutate_number(std::size_t i, const Expression& expression) {
    const auto value = number(word(i));
    if (!value) {
      return;
    }
    const auto is_direction = [this](std::size_t place) {
      return word(place) == "downto" || word(place) == "to";
    };
    const Span all = expression.tokens;
    // The right bound of a slice moves with the left one.
    if (i >= all.first + 2 && is_direction(i - 1) && tokens_[i - 2].kind == Kind::number) {
      return;
    }
    if (i + 2 < all.last && is_direction(i + 1) && tokens_[i + 2].kind == Kind::number) {
      const long right = number(word(i + 2)).value_or(0);
      for (const long step : {1L, -1L}) {
        if (std::min(*value, right) + step >= 0) {
          replace("number", {i, i + 3}, expression.statement,
                  {fmt::format("{} {} {}", *value + step, word(i + 1), right + step)});
        }
      }
      return;
    }
    mutate_token(i, expression.statement, "number", std::to_string(*value + 1));
    if (*value > 0) {
      mutate_token(i, expression.statement, "number", std::to_string(*value - 1));
    }
  }

  static bool is_logical(const std::string& text) {
    return text == "and" || text == "or" || text == "xor" || text == "nand" || text == "nor" ||
           text == "xnor";
  }

  // Operands of logical operators end at these, at the same depth.
  static bool is_boundary(const std::string& text) {
    return text == "," || text == "=>" || text == "when" || text == "else" || text == "|";
  }

  void drop_operands(const Expression& expression) {
    const Span all = expression.tokens;
    for (std::size_t i = all.first; i < all.last; ++i) {
      if (!is_logical(word(i)) || !has_operand_before(i, all)) {
        continue;
      }
      const std::size_t end = operand_end(i + 1, all);
      replace("operand", {i, end}, expression.statement, {""});
      const std::size_t start = operand_start(i, all);
      const bool is_first =
          start == all.first || !is_logical(word(start - 1)) || !has_operand_before(start - 1, all);
      if (is_first) {
        replace("operand", {start, i + 1}, expression.statement, {""});
      }
    }
  }
  std::size_t operand_end(std::size_t i, Span all) const {
    for (int depth = 0; i < all.last; ++i) {
      if (word(i) == ")" && depth == 0) {
        break;
      }
      depth += word(i) == "(" ? 1 : word(i) == ")" ? -1 : 0;
      if (depth == 0 && (is_boundary(word(i)) || is_logical(word(i)))) {
        break;
      }
    }
    return i;
  }
  std::size_t operand_start(std::size_t i, Span all) const {
    for (int depth = 0; i > all.first; --i) {
      const std::string& before = word(i - 1);
      if (before == "(" && depth == 0) {
        break;
      }
      depth += before == ")" ? 1 : before == "(" ? -1 : 0;
      if (depth == 0 && (is_boundary(before) || is_logical(before))) {
        break;
      }
    }
    return i;
  }

  // Arguments and associations in parentheses.
  void mutate_lists(const Expression& expression) {
    for (std::size_t i = expression.tokens.first; i < expression.tokens.last; ++i) {
      if (word(i) != "(") {
        continue;
      }
      const std::size_t end = past_parentheses(i) - 1;
      std::vector<Span> values;
      std::size_t first = i + 1;
      int depth = 0;
      for (std::size_t k = i + 1; k <= end; ++k) {
        if (depth == 0 && (word(k) == "," || k == end)) {
          values.push_back({first, k});
          first = k + 1;
        } else if (depth == 0 && word(k) == "=>") {
          first = k + 1;
        }
        depth += word(k) == "(" ? 1 : word(k) == ")" ? -1 : 0;
      }
      for (std::size_t k = 0; k + 1 < values.size(); ++k) {
        if (values[k].first >= values[k].last || values[k + 1].first >= values[k + 1].last) {
          continue;
        }
        const std::string between = source({values[k].last, values[k + 1].first});
        if (source(values[k]) != source(values[k + 1])) {
          replace("swap", {values[k].first, values[k + 1].last}, expression.statement,
                  {source(values[k + 1]) + " " + between + " " + source(values[k])});
        }
      }
    }
  }

  bool is_field(std::size_t i) const { return i > 0 && word(i - 1) == "."; }
  // Whether it can be another name: no attribute, no formal.
  bool is_name(std::size_t i, Span all) const {
    return tokens_[i].kind == Kind::word && !is_reserved(word(i)) &&
           !(i > 0 && word(i - 1) == "'") && !(i + 1 < all.last && word(i + 1) == "=>");
  }

  static std::vector<std::string> words_of(const std::string& name) {
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
  static double kinship(const std::string& one, const std::string& other) {
    const std::vector<std::string> a = words_of(one);
    const std::vector<std::string> b = words_of(other);
    const auto first = std::ranges::mismatch(a, b).in1 - a.begin();
    const auto last = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend()).first - a.rbegin();
    constexpr double less = 0.01;
    return first != 0 ? static_cast<double>(first) : less * static_cast<double>(last);
  }

  // Every name and the one that takes its place: its nearest relative, of equals the next one in
  // the alphabet. Constants of other files are relatives, but take no place of their own.
  void collect_names() {
    std::set<std::string> names[2];
    for (const Expression& expression : outline_.expressions) {
      for (std::size_t i = expression.tokens.first; i < expression.tokens.last; ++i) {
        if (is_name(i, expression.tokens)) {
          names[is_field(i)].insert(word(i));
        }
      }
    }
    for (const bool fields : {false, true}) {
      std::set<std::string> others = names[fields];
      if (!fields) {
        others.insert(constants_.begin(), constants_.end());
      }
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
        if (!found.empty()) {
          families_[fields][name] = found;
        }
      }
    }
  }

  void swap_arms() {
    for (const std::vector<Expression>& arms : outline_.cases) {
      for (std::size_t i = 0; i + 1 < arms.size(); ++i) {
        const Expression& one = arms[i];
        const Expression& other = arms[i + 1];
        const std::string between = source(other.statement);
        if (one.tokens.first == one.tokens.last || other.tokens.first == other.tokens.last ||
            source(one.tokens) == source(other.tokens)) {
          continue;
        }
        replace("arms", {one.tokens.first, other.tokens.last}, {one.tokens.first, one.tokens.first},
                {source(other.tokens) + "\n" + between + "\n" + source(one.tokens)});
        mutants_.back().id = fmt::format("{}: arms: {} {{<->}} {}", stem_, shown(one.statement),
                                         shown(other.statement));
      }
    }
  }

  void number_equal_ids() {
    std::map<std::string, int> seen;
    for (Mutant& mutant : mutants_) {
      const int count = ++seen[mutant.id];
      if (count > 1) {
        mutant.id += fmt::format(" #{}", count);
      }
    }
  }

  std::string_view text_;
  std::string stem_;
  const std::vector<std::string>& constants_;
  std::vector<Token> tokens_;
  Outline outline_;
  std::map<std::string, std::string> families_[2];
  std::vector<Mutant> mutants_;
};

}  // namespace

std::vector<Mutant> mutants_of(std::string_view text, const std::string& stem,
                               const std::vector<std::string>& constants) {
  return Generator(text, stem, constants).generate();
}

std::vector<std::string> constants_of(std::string_view text) {
  std::vector<std::string> names;
  const std::vector<Token> tokens = tokens_of(text);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text == "constant") {
      names.push_back(tokens[i + 1].text);
    }
  }
  return names;
}

std::string with_mutant(std::string_view text, const Mutant& mutant, std::size_t choice) {
  return fmt::format("{}{}{}", text.substr(0, mutant.begin), mutant.texts.at(choice),
                     text.substr(mutant.end));
}

}  // namespace proof
