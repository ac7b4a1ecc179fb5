// SPDX-License-Identifier: Apache-2.0
// Descends from units through statements; expressions stay flat.
#include "tools/proof/vhdl_outline.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace proof {

namespace {

class Reader {
 public:
  explicit Reader(const std::vector<Token>& tokens) : tokens_(tokens) {}

  Outline read() {
    while (place_ < tokens_.size()) {
      if (is("entity")) {
        skip_to_end_of("entity");
      } else if (is("architecture")) {
        skip_past("is");
        read_declarations(true);
        expect("begin");
        read_concurrent_statements();
        skip_past(";");
      } else if (is("package")) {
        skip_past("is");
        read_declarations(true);
        expect("end");
        skip_past(";");
      } else {
        ++place_;
      }
    }
    return std::move(outline_);
  }

 private:
  bool is(std::string_view text, std::size_t distance = 0) const {
    return place_ + distance < tokens_.size() && tokens_[place_ + distance].text == text;
  }
  bool is_one_of(std::initializer_list<std::string_view> texts) const {
    for (const std::string_view text : texts) {
      if (is(text)) {
        return true;
      }
    }
    return false;
  }
  void expect(std::string_view text) {
    if (!is(text)) {
      const std::string found = place_ < tokens_.size() ? tokens_[place_].text : "the end";
      throw std::runtime_error(
          fmt::format("'{}' stands where '{}' is expected, token {}", found, text, place_));
    }
    ++place_;
  }

  // The next of these texts outside of parentheses, from here on.
  std::size_t find(std::initializer_list<std::string_view> texts) const {
    int depth = 0;
    for (std::size_t i = place_; i < tokens_.size(); ++i) {
      const std::string& text = tokens_[i].text;
      if (depth == 0) {
        for (const std::string_view wanted : texts) {
          if (text == wanted && tokens_[i].kind != Token::Kind::string) {
            return i;
          }
        }
      }
      depth += text == "(" ? 1 : text == ")" ? -1 : 0;
    }
    throw std::runtime_error(fmt::format("no '{}' follows token {}", *texts.begin(), place_));
  }
  void skip_past(std::string_view text) { place_ = find({text}) + 1; }
  void skip_to_end_of(std::string_view unit) {
    while (!(is("end") && is(unit, 1))) {
      skip_past(";");
    }
    skip_past(";");
  }

  void add_expression(Span tokens, Span statement) {
    if (tokens.first < tokens.last) {
      outline_.expressions.push_back({tokens, statement});
    }
  }
  void add_condition(Span tokens, Span statement) {
    add_expression(tokens, statement);
    outline_.conditions.push_back({tokens, statement});
  }

  void read_declarations(bool variables_begin_each_time) {
    while (is_one_of({"signal", "constant", "type", "subtype", "function", "procedure", "pure",
                      "impure", "variable", "shared", "attribute", "alias", "use", "file"})) {
      if (is_one_of({"function", "procedure", "pure", "impure"})) {
        read_subprogram();
        continue;
      }
      const std::size_t start = place_;
      if (is("type")) {
        const std::size_t end = find({"record", ";"});
        if (tokens_[end].text == "record") {
          skip_to_end_of("record");
          continue;
        }
      }
      const bool is_computed =
          is("constant") || (is("variable") && variables_begin_each_time && in_subprogram_);
      const std::size_t end = find({";"});
      if (is_computed) {
        const std::size_t sign = find({":=", ";"});
        if (sign < end) {
          add_expression({sign + 1, end}, {start, end});
          if (in_subprogram_) {
            outline_.values.push_back({{sign + 1, end}, {start, end}});
          }
        }
      }
      place_ = end + 1;
    }
  }

  void read_subprogram() {
    place_ = find({"is", ";"});
    if (is(";")) {
      ++place_;
      return;
    }
    ++place_;
    const bool outer = in_subprogram_;
    in_subprogram_ = true;
    read_declarations(true);
    in_subprogram_ = outer;
    expect("begin");
    read_sequence();
    expect("end");
    skip_past(";");
  }

  void skip_label() {
    if (place_ + 1 < tokens_.size() && tokens_[place_].kind == Token::Kind::word && is(":", 1)) {
      place_ += 2;
    }
  }

  void read_sequence() {
    while (!is_one_of({"end", "elsif", "else", "when"})) {
      read_sequential();
    }
  }

  void read_branch_head(std::string_view end) {
    const std::size_t then = find({end});
    add_condition({place_ + 1, then}, {place_, then});
    place_ = then + 1;
  }

  void read_sequential() {
    const std::size_t start = place_;
    skip_label();
    if (is("if")) {
      read_branch_head("then");
      read_sequence();
      while (is("elsif")) {
        read_branch_head("then");
        read_sequence();
      }
      if (is("else")) {
        ++place_;
        read_sequence();
      }
      expect("end");
      skip_past(";");
    } else if (is("case")) {
      read_case();
    } else if (is("for") || is("while") || is("loop")) {
      read_loop();
    } else if (is_one_of({"wait", "assert", "report", "null"})) {
      skip_past(";");
    } else if (is_one_of({"return", "exit", "next"})) {
      const bool gives_value = is("return");
      const std::size_t end = find({";"});
      ++place_;
      if (gives_value && place_ < end) {
        read_value({start, end});
      } else {
        const std::size_t when = find({"when", ";"});
        if (when < end) {
          add_condition({when + 1, end}, {start, end});
        }
      }
      place_ = end + 1;
    } else {
      const std::size_t end = find({";"});
      outline_.removable.push_back({start, end + 1});
      read_assignment({start, end});
      place_ = end + 1;
    }
  }

  void read_case() {
    const std::size_t head = place_;
    const std::size_t is_word = find({"is"});
    add_expression({place_ + 1, is_word}, {head, is_word});
    place_ = is_word + 1;
    std::vector<Expression> arms;
    while (is("when")) {
      const std::size_t when = place_;
      skip_past("=>");
      const std::size_t first = place_;
      read_sequence();
      arms.push_back({{first, place_}, {when, first}});
    }
    outline_.cases.push_back(std::move(arms));
    expect("end");
    skip_past(";");
  }

  void read_loop() {
    const std::size_t head = place_;
    const std::size_t loop = find({"loop"});
    if (is("for")) {
      add_expression({find({"in"}) + 1, loop}, {head, loop});
    } else if (is("while")) {
      add_condition({head + 1, loop}, {head, loop});
    }
    place_ = loop + 1;
    read_sequence();
    expect("end");
    skip_past(";");
  }

  // A target with `<=` or `:=`, or a call, from here to the end of the statement.
  void read_assignment(Span statement) {
    const std::size_t sign = find({"<=", ":=", ";"});
    if (sign >= statement.last) {
      const std::size_t parenthesis = find({"(", ";"});
      if (parenthesis < statement.last) {
        add_expression({parenthesis, statement.last}, statement);
      }
      return;
    }
    const std::size_t parenthesis = find({"(", "<=", ":="});
    if (parenthesis < sign) {
      add_expression({parenthesis, sign}, statement);
    }
    place_ = sign + 1;
    read_value(statement);
  }

  // VALUE [when CONDITION else VALUE]... up to the end of the statement.
  void read_value(Span statement) {
    add_expression({place_, statement.last}, statement);
    while (place_ < statement.last) {
      const std::size_t when = find({"when", ";"});
      outline_.values.push_back({{place_, when}, statement});
      place_ = when + 1;
      if (when < statement.last) {
        const std::size_t other = find({"else", ";"});
        outline_.conditions.push_back({{place_, other}, statement});
        place_ = other + 1;
      }
    }
  }

  void read_concurrent_statements() {
    while (!is_one_of({"end", "elsif", "else"})) {
      read_concurrent();
    }
    if (is("end")) {
      ++place_;
    }
  }

  void read_concurrent() {
    const std::size_t start = place_;
    skip_label();
    if (is("process")) {
      ++place_;
      if (is("(")) {
        skip_parentheses();
      }
      if (is("is")) {
        ++place_;
      }
      read_declarations(false);
      expect("begin");
      read_sequence();
      expect("end");
      skip_past(";");
    } else if (is("block")) {
      ++place_;
      read_region();
      skip_past(";");
    } else if (is("for")) {
      const std::size_t head = place_;
      const std::size_t generate = find({"generate"});
      add_expression({find({"in"}) + 1, generate}, {head, generate});
      place_ = generate + 1;
      read_region();
      skip_past(";");
    } else if (is("if")) {
      read_branch_head("generate");
      read_region();
      while (is_one_of({"elsif", "else"})) {
        if (is("elsif")) {
          read_branch_head("generate");
        } else {
          skip_past("generate");
        }
        read_region();
      }
      skip_past(";");
    } else if (is("assert") || is("with")) {
      skip_past(";");
    } else if (is("entity") || is("component")) {
      read_instance();
    } else {
      const std::size_t end = find({";"});
      read_assignment({start, end});
      place_ = end + 1;
    }
  }

  // Of a block or a generate statement, past its `end` or up to its next branch.
  void read_region() {
    read_declarations(true);
    if (is("begin")) {
      ++place_;
    }
    read_concurrent_statements();
  }

  void skip_parentheses() {
    int depth = 0;
    do {
      depth += is("(") ? 1 : is(")") ? -1 : 0;
      ++place_;
    } while (depth > 0);
  }

  // Each actual of the maps, in the form FORMAL => ACTUAL.
  void read_instance() {
    const std::size_t end = find({";"});
    for (std::size_t map = place_; map < end; ++map) {
      if (tokens_[map].text != "map") {
        continue;
      }
      place_ = map + 2;
      bool more = true;
      while (more) {
        const std::size_t formal = place_;
        const std::size_t last = find({",", ")"});
        const std::size_t arrow = find({"=>"});
        add_expression({arrow + 1, last}, {formal, last});
        more = tokens_[last].text == ",";
        place_ = last + 1;
      }
    }
    place_ = end + 1;
  }

  const std::vector<Token>& tokens_;
  std::size_t place_ = 0;
  bool in_subprogram_ = false;
  Outline outline_;
};

}  // namespace

Outline outline_of(const std::vector<Token>& tokens) { return Reader(tokens).read(); }

}  // namespace proof
