// SPDX-License-Identifier: Apache-2.0
// Mutants in the making: their places in the file, and ids that say what is changed.
#pragma once

#include <string>
#include <vector>

#include "tools/proof/mutants.hpp"
#include "tools/proof/vhdl_text.hpp"

namespace proof {

class MutantDraft {
 public:
  // `text` must outlive this.
  MutantDraft(const VhdlText& text, std::string stem) : text_(text), stem_(std::move(stem)) {}

  // `statement` is what the id shows around `span`.
  void replace(const char* kind, Span span, Span statement, std::vector<std::string> texts);
  // The same with an id of its own.
  void replace_shown_as(const std::string& shown, const char* kind, Span span,
                        std::vector<std::string> texts);

  // The mutants so far, with equal ids numbered.
  std::vector<Mutant> finish();

 private:
  const VhdlText& text_;
  std::string stem_;
  std::vector<Mutant> mutants_;
};

}  // namespace proof
