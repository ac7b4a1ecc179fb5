// SPDX-License-Identifier: Apache-2.0
// The whole way with GHDL, Yosys and the solvers, on a counter: what holds holds, what does
// not is reported.
#include <gmock/gmock.h>

#include "tests/proof/counter_folder.hpp"
#include "tools/proof/task.hpp"

namespace {

using proof::Verdict;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string counter = R"(library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity counter is
  port (
    clk : in std_ulogic;
    advance : in std_ulogic;
    count : out unsigned(3 downto 0) := (others => '0')
  );
end entity;

architecture rtl of counter is
begin

  work : process
  begin
    wait until rising_edge(clk);
    if advance then
      count <= count + 1;
      if count = 5 then
        count <= (others => '0');
      end if;
    end if;
  end process;

end architecture;
)";

const std::string properties = R"(vunit counter_properties (counter(rtl)) {
  default clock is rising_edge(clk);
  count_stays_below_six : assert always (count < 6);
  count_is_never_seven : assert always (count /= 7);
  count_stays_below_four : assert always (count < 4);
}
)";

// Counts in every clock.
const std::string bench = counter_bench("advance => '1', ");

class Trial : public testing::Test {
 protected:
  Trial() { std::filesystem::create_directories(folders_.work); }

  proof::Proof proof_of(const std::string& property, proof::Method method, int depth) const {
    proof::Proof proof;
    proof.name = property;
    proof.method = method;
    proof.depth = depth;
    proof.entity = "counter";
    proof.only = {property};
    return proof;
  }

  proof::Outcome outcome_of(const proof::Proof& proof) const {
    prepare_sources(folders_, folders_.work / "sources", nullptr);
    return try_proof(folders_, proof, folders_.work / "sources", limit);
  }

  proof::Mutation mutation(const std::string& property, int depth) const {
    proof::Mutation mutation;
    mutation.name = "counts_too_far";
    mutation.file = "rtl/counter.vhd";
    mutation.from = "count = 5";
    mutation.to = "count = 6";
    mutation.property = property;
    mutation.depth = depth;
    return mutation;
  }

  static constexpr std::chrono::seconds limit{60};
  CounterFolder folder_{counter, properties};
  proof::Folders folders_{folder_.path(), folder_.path() / "work"};
};

TEST_F(Trial, an_induction_proves_what_always_holds) {
  const auto outcome = outcome_of(proof_of("count_stays_below_six", proof::Method::induction, 1));
  EXPECT_EQ(outcome.verdict, Verdict::holds) << outcome.explanation;
  EXPECT_THAT(outcome.asserted, ElementsAre("counter_properties_count_stays_below_six"));
}

TEST_F(Trial, an_induction_that_does_not_close_is_reported) {
  const auto outcome = outcome_of(proof_of("count_is_never_seven", proof::Method::induction, 1));
  EXPECT_EQ(outcome.verdict, Verdict::fails);
  EXPECT_THAT(outcome.explanation, HasSubstr("the induction does not close"));
}

TEST_F(Trial, what_is_reached_from_the_start_fails_with_its_name_clock_and_trace) {
  for (const auto method : {proof::Method::induction, proof::Method::bounded}) {
    const auto outcome = outcome_of(proof_of("count_stays_below_four", method, 8));
    EXPECT_EQ(outcome.verdict, Verdict::fails);
    EXPECT_THAT(outcome.explanation, HasSubstr("count_stays_below_four fails 4 clocks after"));
    EXPECT_TRUE(std::filesystem::exists(folders_.work / "count_stays_below_four" / "bounded.vcd"));
  }
}

TEST_F(Trial, the_values_that_a_signal_takes_are_counted) {
  proof::Proof proof = proof_of("count_stays_below_six", proof::Method::sighting, 2);
  proof.signals = {"count"};
  proof.values = 1;
  EXPECT_EQ(outcome_of(proof).verdict, Verdict::holds);
  proof.values = 2;
  const auto outcome = outcome_of(proof);
  EXPECT_EQ(outcome.verdict, Verdict::fails);
  EXPECT_THAT(outcome.explanation, HasSubstr("1 values instead of 2 are seen within 2 clocks"));
}

TEST_F(Trial, a_stand_in_takes_the_place_of_a_source) {
  folder_.write("testbench/proofs/parts/counter.vhdl", counter);
  auto proof = proof_of("stand_in", proof::Method::bounded, 2);
  proof.only = {};
  proof.stand_ins = {"parts/counter.vhdl"};
  // The properties are woven into the source, so the stand-in has none.
  EXPECT_THAT(outcome_of(proof).explanation, HasSubstr("there is nothing to prove"));
}

TEST_F(Trial, a_stand_in_for_nothing_is_an_error) {
  folder_.write("testbench/proofs/other.vhdl", counter);
  auto proof = proof_of("count_stays_below_six", proof::Method::bounded, 2);
  for (const char* file : {"other.vhdl", "counter.vhdl"}) {
    proof.stand_ins = {file};
    const auto outcome = outcome_of(proof);
    EXPECT_EQ(outcome.verdict, Verdict::broken);
    EXPECT_THAT(outcome.explanation, HasSubstr("stands in for no source, or is not there"));
  }
}

TEST_F(Trial, a_bounded_proof_says_nothing_of_later_clocks) {
  const auto outcome = outcome_of(proof_of("count_stays_below_four", proof::Method::bounded, 4));
  EXPECT_EQ(outcome.verdict, Verdict::holds) << outcome.explanation;
}

TEST_F(Trial, a_mutation_is_caught_by_its_property_and_by_no_other) {
  const proof::Proof proof = proof_of("count_stays_below_six", proof::Method::induction, 1);
  EXPECT_EQ(try_mutation(folders_, mutation("count_stays_below_six", 12), proof, limit).verdict,
            Verdict::holds);
  std::filesystem::remove_all(folders_.work / "mutations");
  EXPECT_EQ(try_mutation(folders_, mutation("count_is_never_seven", 12), proof, limit).verdict,
            Verdict::fails);
}

TEST_F(Trial, a_mutation_too_deep_for_its_clocks_survives) {
  const proof::Proof proof = proof_of("count_stays_below_six", proof::Method::induction, 1);
  const auto outcome = try_mutation(folders_, mutation("count_stays_below_six", 4), proof, limit);
  EXPECT_EQ(outcome.verdict, Verdict::fails);
  EXPECT_THAT(outcome.explanation, HasSubstr("survives"));
}

TEST_F(Trial, a_bench_catches_a_mutation_that_it_can_see) {
  folder_.write("testbench/proofs/counter.psl",
                "vunit counter_properties (counter(rtl)) {\n  default clock is rising_edge(clk);\n"
                "  count_stays_below_six : assert always (count < 6);\n}\n");
  folder_.write("testbench/counter_tb.vhd", bench);
  auto by_bench = proof_of("counter_bench", proof::Method::bench, 0);
  by_bench.entity = "counter_tb";
  const auto outcome = outcome_of(by_bench);
  EXPECT_EQ(outcome.verdict, Verdict::holds) << outcome.explanation;
  EXPECT_EQ(try_mutation(folders_, mutation("", 0), by_bench, limit).verdict, Verdict::holds);
  std::filesystem::remove_all(folders_.work / "mutations");
  auto unseen = mutation("", 0);
  unseen.from = "unsigned(3 downto 0) :=";
  unseen.to = "unsigned(3 downto 0)  :=";
  EXPECT_THAT(try_mutation(folders_, unseen, by_bench, limit).explanation, HasSubstr("survives"));
}

TEST_F(Trial, a_mutation_that_does_not_compile_is_not_caught_by_a_bench) {
  folder_.write("testbench/counter_tb.vhd", bench);
  auto by_bench = proof_of("counter_bench", proof::Method::bench, 0);
  by_bench.entity = "counter_tb";
  auto nonsense = mutation("", 0);
  nonsense.to = "count = ";
  EXPECT_EQ(try_mutation(folders_, nonsense, by_bench, limit).verdict, Verdict::broken);
}

TEST_F(Trial, a_fault_by_which_a_value_is_not_taken_any_more_is_caught_by_a_sighting) {
  proof::Proof proof = proof_of("count_stays_below_six", proof::Method::sighting, 6);
  proof.signals = {"count"};
  proof.values = 1;
  auto fault = mutation("", 0);
  EXPECT_THAT(try_mutation(folders_, fault, proof, limit).explanation, HasSubstr("survives"));
  std::filesystem::remove_all(folders_.work / "mutations");
  fault.from = "count <= count + 1;";
  fault.to = "count <= count;";
  EXPECT_EQ(try_mutation(folders_, fault, proof, limit).verdict, Verdict::holds);
}

TEST_F(Trial, a_fault_in_a_lemma_is_caught_where_it_has_a_solution) {
  folder_.write("testbench/proofs/sum.smt2",
                "(declare-const x Int)\n(assert (not (= (+ x x) (* 2 x))))\n(check-sat)\n");
  proof::Proof lemma;
  lemma.name = "sum";
  lemma.method = proof::Method::arithmetic;
  lemma.lemma = "sum.smt2";
  EXPECT_EQ(try_proof(folders_, lemma, {}, limit).verdict, Verdict::holds);
  auto fault = mutation("", 0);
  fault.file = "testbench/proofs/sum.smt2";
  fault.from = "(* 2 x)";
  fault.to = "(* 3 x)";
  EXPECT_EQ(try_mutation(folders_, fault, lemma, limit).verdict, Verdict::holds);
  fault.to = "(* x 2)";
  EXPECT_THAT(try_mutation(folders_, fault, lemma, limit).explanation, HasSubstr("survives"));
  fault.to = "(* 3 y)";
  EXPECT_EQ(try_mutation(folders_, fault, lemma, limit).verdict, Verdict::broken);
}

TEST_F(Trial, sources_that_do_not_compile_are_reported) {
  folder_.write("rtl/counter.vhd", counter + "nonsense");
  const auto outcome = outcome_of(proof_of("count_stays_below_six", proof::Method::induction, 1));
  EXPECT_EQ(outcome.verdict, Verdict::broken);
}

}  // namespace
