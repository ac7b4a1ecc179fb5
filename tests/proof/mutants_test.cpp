// SPDX-License-Identifier: Apache-2.0
// Which faults are made of a text, and which are not.
#include "tools/proof/mutants.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "tools/proof/vhdl_outline.hpp"
#include "tools/proof/vhdl_tokens.hpp"

namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (const proof::Token& token : proof::tokens_of(text)) words.push_back(token.text);
  return words;
}

// The statements in the body of a clocked process.
std::string in_a_process(const std::string& statements) {
  return "architecture rtl of part is\n  signal a : std_ulogic := '0';\nbegin\n"
         "  work : process\n    variable v : natural := 3;\n  begin\n"
         "    wait until rising_edge(clk);\n" +
         statements + "  end process;\nend architecture;\n";
}

// The changed texts of one operator.
std::vector<std::string> changes(const std::string& text, const std::string& kind) {
  std::vector<std::string> found;
  for (const proof::Mutant& mutant : proof::mutants_of(text, "part")) {
    if (mutant.kind == kind) {
      found.push_back(text.substr(mutant.begin, mutant.end - mutant.begin) + "|" +
                      mutant.texts.front());
    }
  }
  return found;
}

TEST(vhdl_tokens, knows_comments_characters_ticks_and_bit_strings) {
  EXPECT_THAT(words_of("A <= '1' when x'high = 3 else y; -- b <= c"),
              ElementsAre("a", "<=", "'1'", "when", "x", "'", "high", "=", "3", "else", "y", ";"));
  EXPECT_THAT(words_of("return '0' & x\"0F\" & t'('1')"),
              ElementsAre("return", "'0'", "&", "x\"0F\"", "&", "t", "'", "(", "'1'", ")"));
  EXPECT_THROW(proof::tokens_of("s <= \"01"), std::runtime_error);
}

TEST(vhdl_tokens, reports_where_they_stand) {
  const auto tokens = proof::tokens_of("-- x\n  ab;");
  EXPECT_EQ(tokens.at(0).begin, 7u);
  EXPECT_EQ(tokens.at(0).end, 9u);
}

TEST(mutants, leave_declarations_entities_waits_and_assertions_alone) {
  const std::string text = "entity part is\n  generic (width : natural := 4);\nend entity;\n" +
                           in_a_process("    assert a = '1' report \"1\" severity failure;\n");
  EXPECT_THAT(proof::mutants_of(text, "part"), IsEmpty());
}

TEST(mutants, negate_conditions_that_are_more_than_one_comparison) {
  const std::string text = in_a_process(
      "    if a and b then\n      x <= y;\n    elsif c = 0 then\n      null;\n    end if;\n"
      "    z <= '1' when not d else '0';\n");
  EXPECT_THAT(changes(text, "negate"), ElementsAre("a and b|not (a and b)", "not d|not (not d)"));
}

TEST(mutants, drop_assignments_and_calls_in_sequence_only) {
  const std::string text = in_a_process("    x <= y;\n    v := 4;\n    put(x);\n");
  EXPECT_THAT(changes(text, "drop"),
              ElementsAre("x <= y;|null;", "v := 4;|null;", "put(x);|null;"));
  EXPECT_THAT(changes("architecture rtl of p is begin x <= y; end architecture;", "drop"),
              IsEmpty());
}

TEST(mutants, tell_assignment_and_comparison_apart) {
  const std::string text = in_a_process("    x <= '1' when a <= b else '0';\n");
  EXPECT_THAT(changes(text, "relation"), ElementsAre("<=|<", "<=|>"));
}

TEST(mutants, change_comparisons_by_boundary_and_opposite) {
  EXPECT_THAT(changes(in_a_process("    if a < b then c <= d; end if;\n"), "relation"),
              ElementsAre("<|<=", "<|>="));
  EXPECT_THAT(changes(in_a_process("    if a = b then c <= d; end if;\n"), "relation"),
              ElementsAre("=|/=", "=|>=", "=|<="));
  EXPECT_THAT(changes(in_a_process("    if a = '1' then c <= d; end if;\n"), "relation"),
              ElementsAre("=|/="));
}

TEST(mutants, leave_out_each_operand_of_a_chain) {
  const std::string text = in_a_process("    x <= a and (b or c(1)) and d;\n");
  EXPECT_THAT(changes(text, "operand"),
              UnorderedElementsAre("and (b or c(1))|", "a and|", "or c(1)|", "b or|", "and d|"));
}

TEST(mutants, take_reductions_for_no_operands) {
  EXPECT_THAT(changes(in_a_process("    x <= or y;\n"), "operand"), IsEmpty());
  EXPECT_THAT(changes(in_a_process("    x <= or y;\n"), "logic"), ElementsAre("or|and"));
}

TEST(mutants, change_numbers_by_one_and_move_slices_as_a_whole) {
  const std::string text = in_a_process("    x <= y(3 downto 1) + 0;\n    z <= y(2);\n");
  EXPECT_THAT(changes(text, "number"),
              ElementsAre("3 downto 1|4 downto 2", "3 downto 1|2 downto 0", "0|1", "2|3", "2|1"));
}

TEST(mutants, flip_bits_but_not_where_the_comparison_is_turned) {
  const std::string text =
      in_a_process("    if a = '1' then b <= '0'; end if;\n    c <= x\"00\";\n");
  EXPECT_THAT(changes(text, "bit"), ElementsAre("'0'|'1'", "x\"00\"|x\"01\""));
}

TEST(mutants, make_values_and_parts_of_concatenations_zero) {
  const std::string text =
      "package body p is\n  function f(v : unsigned) return unsigned is\n  begin\n"
      "    return '0' & floor & x\"00\";\n  end function;\nend package body;\n";
  EXPECT_THAT(
      changes(text, "zero"),
      ElementsAre("'0' & floor & x\"00\"|('0' & floor & x\"00\") xor ('0' & floor & x\"00\")",
                  "floor|(floor xor floor)"));
}

TEST(mutants, swap_neighbours_in_lists) {
  EXPECT_THAT(changes(in_a_process("    x <= f(a, b, b);\n"), "swap"), ElementsAre("a, b|b , a"));
  EXPECT_THAT(changes("architecture rtl of p is begin u : entity work.q port map (i => a, o => b);"
                      " end architecture;",
                      "swap"),
              IsEmpty());
  EXPECT_THAT(changes(in_a_process("    x <= (one => a, two => b);\n"), "swap"),
              ElementsAre("a, two => b|b , two => a"));
}

TEST(mutants, take_a_relative_for_a_name) {
  const std::string text =
      in_a_process("    x <= state_ok;\n    y <= state_time_out;\n    z <= r.low;\n");
  EXPECT_THAT(changes(text, "name"),
              UnorderedElementsAre("state_ok|state_time_out", "state_time_out|state_ok"));
}

TEST(mutants, take_a_constant_of_a_package_for_its_relative) {
  const std::string text = in_a_process("    x <= y(state_ok);\n");
  const std::vector<std::string> constants =
      proof::constants_of("constant state_open : natural := 2; constant other : natural := 3;");
  EXPECT_THAT(constants, ElementsAre("state_open", "other"));
  const auto mutants = proof::mutants_of(text, "part", constants);
  EXPECT_EQ(std::ranges::count(mutants, "name", &proof::Mutant::kind), 1);
}

TEST(mutants, swap_the_arms_of_a_case) {
  const std::string text = in_a_process(
      "    case s is\n      when one => x <= y;\n      when two | three => x <= z;\n    end "
      "case;\n");
  const auto mutants = proof::mutants_of(text, "part");
  const auto arms = std::ranges::find(mutants, "arms", &proof::Mutant::kind);
  ASSERT_NE(arms, mutants.end());
  EXPECT_EQ(arms->id, "part: arms: when one => {<->} when two | three =>");
  EXPECT_THAT(proof::with_mutant(text, *arms),
              HasSubstr("when one => x <= z;\nwhen two | three =>\nx <= y;"));
}

TEST(mutants, have_ids_that_stay_where_other_statements_change) {
  const std::string before = in_a_process("    x <= y;\n");
  const std::string after = in_a_process("    a <= b;\n\n    x <= y;\n");
  std::set<std::string> ids;
  for (const proof::Mutant& mutant : proof::mutants_of(after, "part")) {
    EXPECT_TRUE(ids.insert(mutant.id).second) << mutant.id;
  }
  for (const proof::Mutant& mutant : proof::mutants_of(before, "part")) {
    EXPECT_THAT(ids, Contains(mutant.id));
  }
}

TEST(mutants, with_equal_texts_are_numbered) {
  const auto mutants = proof::mutants_of(in_a_process("    x <= y;\n    x <= y;\n"), "part");
  EXPECT_EQ(mutants.at(0).id, "part: drop: x <= y;");
  EXPECT_EQ(mutants.at(1).id, "part: drop: x <= y; #2");
}

TEST(mutants, change_the_actuals_of_an_instance_and_generate_conditions) {
  const std::string text =
      "architecture rtl of p is begin\n  all_of : for i in 0 to 3 generate\n"
      "    some : if i < 2 generate\n      u : entity work.q generic map (n => 7) port map "
      "(d => e(i) and f);\n    end generate;\n  end generate;\nend architecture;\n";
  EXPECT_THAT(changes(text, "number"),
              UnorderedElementsAre("0 to 3|1 to 4", "2|3", "2|1", "7|8", "7|6"));
  EXPECT_THAT(changes(text, "relation"), ElementsAre("<|<=", "<|>="));
  EXPECT_THAT(changes(text, "operand"), ElementsAre("and f|", "e(i) and|"));
}

TEST(mutants, refuse_what_they_do_not_understand) {
  EXPECT_THROW(proof::mutants_of("architecture rtl of p is begin x <= y", "p"), std::runtime_error);
}

}  // namespace
