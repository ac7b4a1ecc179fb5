// SPDX-License-Identifier: Apache-2.0
// Faults made systematically from the text of a VHDL file, by operators of the mutation literature.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proof {

struct Mutant {
  // File, operator and the changed text within its statement; equal ones are numbered. Stays as it
  // is where other statements change.
  std::string id;
  std::string kind;
  std::size_t begin{};  // offsets in the file
  std::size_t end{};
  // What takes the place of that text: the first of these that compiles.
  std::vector<std::string> texts;
};

// The operators:
//   negate      a condition of if, elsif, while, when, exit, next
//   drop        an assignment or call in sequence
//   logic       and <-> or, xor <-> xnor; `not` left out
//   operand     one operand of a chain of and, or, xor left out
//   relation    = <-> /=, = by >= and <=, each of < <= > >= by its boundary and by its opposite
//   arithmetic  + <-> -, * <-> +
//   number      a whole number one more and one less (as the bound of a slice: the slice moved)
//   bit         '0' <-> '1', the last digit of a bit string
//   zero        what is assigned or returned, or a part of a concatenation, is 0
//   swap        neighbours in a list of arguments, or what is associated with neighbouring names
//   name        the name that shares most of its first words, or else of its last words
//   arms        the statements of neighbouring arms of a case
// `stem` names the file in the ids; `constants` are those of the packages that it uses, by which
// `name` may replace others. Throws as `tokens_of` and `outline_of` do.
std::vector<Mutant> mutants_of(std::string_view text, const std::string& stem,
                               const std::vector<std::string>& constants = {});

// The constants that a file declares.
std::vector<std::string> constants_of(std::string_view text);

std::string with_mutant(std::string_view text, const Mutant& mutant, std::size_t choice = 0);

}  // namespace proof
