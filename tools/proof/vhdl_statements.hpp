// SPDX-License-Identifier: Apache-2.0
// The sequential statements of a VHDL file, and the parts that concurrent ones share with them.
#pragma once

#include "tools/proof/vhdl_cursor.hpp"
#include "tools/proof/vhdl_outline.hpp"

namespace proof {

class StatementReader {
 public:
  // Adds to the outline what it reads from the cursor's place on; both must outlive this.
  StatementReader(VhdlCursor& cursor, Outline& outline) : cursor_(cursor), outline_(outline) {}

  void add_expression(Span tokens, Span statement);
  // Up to `end`, `elsif`, `else` or `when`.
  void read_sequence();
  // WORD CONDITION then, or another word for `then`.
  void read_branch_head(std::string_view end);
  // A target with `<=` or `:=`, or a call, from here to the end of the statement.
  void read_assignment(Span statement);

 private:
  void add_condition(Span tokens, Span statement);
  void read_sequential();
  void read_case();
  void read_loop();
  // VALUE [when CONDITION else VALUE]... up to the end of the statement.
  void read_value(Span statement);

  VhdlCursor& cursor_;
  Outline& outline_;
};

}  // namespace proof
