// SPDX-License-Identifier: Apache-2.0
// Descends from statements to expressions, which stay flat.
#include "tools/proof/vhdl_statements.hpp"

namespace proof {

void StatementReader::add_expression(Span tokens, Span statement) {
  if (tokens.first < tokens.last) outline_.expressions.push_back({tokens, statement});
}

void StatementReader::add_condition(Span tokens, Span statement) {
  add_expression(tokens, statement);
  outline_.conditions.push_back({tokens, statement});
}

void StatementReader::read_sequence() {
  while (!cursor_.is_one_of({"end", "elsif", "else", "when"})) read_sequential();
}

void StatementReader::read_branch_head(std::string_view end) {
  const std::size_t then = cursor_.find({end});
  add_condition({cursor_.place() + 1, then}, {cursor_.place(), then});
  cursor_.go_to(then + 1);
}

void StatementReader::read_sequential() {
  const std::size_t start = cursor_.place();
  cursor_.skip_label();
  if (cursor_.is("if")) {
    read_branch_head("then");
    read_sequence();
    while (cursor_.is("elsif")) {
      read_branch_head("then");
      read_sequence();
    }
    if (cursor_.is("else")) {
      cursor_.advance();
      read_sequence();
    }
    cursor_.expect("end");
    cursor_.skip_past(";");
  } else if (cursor_.is("case")) {
    read_case();
  } else if (cursor_.is("for") || cursor_.is("while") || cursor_.is("loop")) {
    read_loop();
  } else if (cursor_.is_one_of({"wait", "assert", "report", "null"})) {
    cursor_.skip_past(";");
  } else if (cursor_.is_one_of({"return", "exit", "next"})) {
    const bool gives_value = cursor_.is("return");
    const std::size_t end = cursor_.find({";"});
    cursor_.advance();
    if (gives_value && cursor_.place() < end) {
      read_value({start, end});
    } else {
      const std::size_t when = cursor_.find({"when", ";"});
      if (when < end) add_condition({when + 1, end}, {start, end});
    }
    cursor_.go_to(end + 1);
  } else {
    const std::size_t end = cursor_.find({";"});
    outline_.removable.push_back({start, end + 1});
    read_assignment({start, end});
    cursor_.go_to(end + 1);
  }
}

void StatementReader::read_case() {
  const std::size_t head = cursor_.place();
  const std::size_t is_word = cursor_.find({"is"});
  add_expression({cursor_.place() + 1, is_word}, {head, is_word});
  cursor_.go_to(is_word + 1);
  std::vector<Expression> arms;
  while (cursor_.is("when")) {
    const std::size_t when = cursor_.place();
    cursor_.skip_past("=>");
    const std::size_t first = cursor_.place();
    read_sequence();
    arms.push_back({{first, cursor_.place()}, {when, first}});
  }
  outline_.cases.push_back(std::move(arms));
  cursor_.expect("end");
  cursor_.skip_past(";");
}

void StatementReader::read_loop() {
  const std::size_t head = cursor_.place();
  const std::size_t loop = cursor_.find({"loop"});
  if (cursor_.is("for")) {
    add_expression({cursor_.find({"in"}) + 1, loop}, {head, loop});
  } else if (cursor_.is("while")) {
    add_condition({head + 1, loop}, {head, loop});
  }
  cursor_.go_to(loop + 1);
  read_sequence();
  cursor_.expect("end");
  cursor_.skip_past(";");
}

void StatementReader::read_assignment(Span statement) {
  const std::size_t sign = cursor_.find({"<=", ":=", ";"});
  if (sign >= statement.last) {
    const std::size_t parenthesis = cursor_.find({"(", ";"});
    if (parenthesis < statement.last) add_expression({parenthesis, statement.last}, statement);
    return;
  }
  const std::size_t parenthesis = cursor_.find({"(", "<=", ":="});
  if (parenthesis < sign) add_expression({parenthesis, sign}, statement);
  cursor_.go_to(sign + 1);
  read_value(statement);
}

void StatementReader::read_value(Span statement) {
  add_expression({cursor_.place(), statement.last}, statement);
  while (cursor_.place() < statement.last) {
    const std::size_t when = cursor_.find({"when", ";"});
    outline_.values.push_back({{cursor_.place(), when}, statement});
    cursor_.go_to(when + 1);
    if (when < statement.last) {
      const std::size_t other = cursor_.find({"else", ";"});
      outline_.conditions.push_back({{cursor_.place(), other}, statement});
      cursor_.go_to(other + 1);
    }
  }
}

}  // namespace proof
