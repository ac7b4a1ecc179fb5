// SPDX-License-Identifier: Apache-2.0
// Descends from units through declarations and concurrent statements.
#include "tools/proof/vhdl_outline.hpp"

#include "tools/proof/vhdl_cursor.hpp"
#include "tools/proof/vhdl_statements.hpp"

namespace proof {

namespace {

class UnitReader {
 public:
  explicit UnitReader(const std::vector<Token>& tokens)
      : cursor_(tokens), statements_(cursor_, outline_) {}

  Outline read() {
    while (!cursor_.at_end()) {
      if (cursor_.is("entity")) {
        cursor_.skip_to_end_of("entity");
      } else if (cursor_.is("architecture")) {
        cursor_.skip_past("is");
        read_declarations(true);
        cursor_.expect("begin");
        read_concurrent_statements();
        cursor_.skip_past(";");
      } else if (cursor_.is("package")) {
        cursor_.skip_past("is");
        read_declarations(true);
        cursor_.expect("end");
        cursor_.skip_past(";");
      } else {
        cursor_.advance();
      }
    }
    return std::move(outline_);
  }

 private:
  void read_declarations(bool variables_begin_each_time) {
    while (
        cursor_.is_one_of({"signal", "constant", "type", "subtype", "function", "procedure", "pure",
                           "impure", "variable", "shared", "attribute", "alias", "use", "file"})) {
      if (cursor_.is_one_of({"function", "procedure", "pure", "impure"})) {
        read_subprogram();
        continue;
      }
      const std::size_t start = cursor_.place();
      if (cursor_.is("type")) {
        const std::size_t end = cursor_.find({"record", ";"});
        if (cursor_.text_at(end) == "record") {
          cursor_.skip_to_end_of("record");
          continue;
        }
      }
      const bool is_computed =
          cursor_.is("constant") ||
          (cursor_.is("variable") && variables_begin_each_time && in_subprogram_);
      const std::size_t end = cursor_.find({";"});
      if (is_computed) {
        const std::size_t sign = cursor_.find({":=", ";"});
        if (sign < end) {
          statements_.add_expression({sign + 1, end}, {start, end});
          if (in_subprogram_) outline_.values.push_back({{sign + 1, end}, {start, end}});
        }
      }
      cursor_.go_to(end + 1);
    }
  }

  void read_subprogram() {
    cursor_.go_to(cursor_.find({"is", ";"}));
    if (cursor_.is(";")) {
      cursor_.advance();
      return;
    }
    cursor_.advance();
    const bool outer = in_subprogram_;
    in_subprogram_ = true;
    read_declarations(true);
    in_subprogram_ = outer;
    cursor_.expect("begin");
    statements_.read_sequence();
    cursor_.expect("end");
    cursor_.skip_past(";");
  }

  void read_concurrent_statements() {
    while (!cursor_.is_one_of({"end", "elsif", "else"})) read_concurrent();
    if (cursor_.is("end")) cursor_.advance();
  }

  void read_concurrent() {
    const std::size_t start = cursor_.place();
    cursor_.skip_label();
    if (cursor_.is("process")) {
      cursor_.advance();
      if (cursor_.is("(")) {
        cursor_.skip_parentheses();
      }
      if (cursor_.is("is")) cursor_.advance();
      read_declarations(false);
      cursor_.expect("begin");
      statements_.read_sequence();
      cursor_.expect("end");
      cursor_.skip_past(";");
    } else if (cursor_.is("block")) {
      cursor_.advance();
      read_region();
      cursor_.skip_past(";");
    } else if (cursor_.is("for")) {
      const std::size_t head = cursor_.place();
      const std::size_t generate = cursor_.find({"generate"});
      statements_.add_expression({cursor_.find({"in"}) + 1, generate}, {head, generate});
      cursor_.go_to(generate + 1);
      read_region();
      cursor_.skip_past(";");
    } else if (cursor_.is("if")) {
      statements_.read_branch_head("generate");
      read_region();
      while (cursor_.is_one_of({"elsif", "else"})) {
        if (cursor_.is("elsif")) {
          statements_.read_branch_head("generate");
        } else {
          cursor_.skip_past("generate");
        }
        read_region();
      }
      cursor_.skip_past(";");
    } else if (cursor_.is("assert") || cursor_.is("with")) {
      cursor_.skip_past(";");
    } else if (cursor_.is("entity") || cursor_.is("component")) {
      read_instance();
    } else {
      const std::size_t end = cursor_.find({";"});
      statements_.read_assignment({start, end});
      cursor_.go_to(end + 1);
    }
  }

  // Of a block or a generate statement, past its `end` or up to its next branch.
  void read_region() {
    read_declarations(true);
    if (cursor_.is("begin")) cursor_.advance();
    read_concurrent_statements();
  }

  // Each actual of the maps, in the form FORMAL => ACTUAL.
  void read_instance() {
    const std::size_t end = cursor_.find({";"});
    for (std::size_t map = cursor_.place(); map < end; ++map) {
      if (cursor_.text_at(map) != "map") continue;
      cursor_.go_to(map + 2);
      bool more = true;
      while (more) {
        const std::size_t formal = cursor_.place();
        const std::size_t last = cursor_.find({",", ")"});
        const std::size_t arrow = cursor_.find({"=>"});
        statements_.add_expression({arrow + 1, last}, {formal, last});
        more = cursor_.text_at(last) == ",";
        cursor_.go_to(last + 1);
      }
    }
    cursor_.go_to(end + 1);
  }

  Outline outline_;
  VhdlCursor cursor_;
  StatementReader statements_;
  bool in_subprogram_ = false;
};

}  // namespace

Outline outline_of(const std::vector<Token>& tokens) { return UnitReader(tokens).read(); }

}  // namespace proof
