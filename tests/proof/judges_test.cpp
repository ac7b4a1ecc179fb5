// SPDX-License-Identifier: Apache-2.0
// The judges of mutants on a counter, with GHDL and Yosys.
#include "tools/proof/mutant_judges.hpp"

#include <gmock/gmock.h>

#include "tests/proof/counter_folder.hpp"

namespace {

using proof::Finding;
using testing::ElementsAre;

const std::string counter = R"(library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity counter is
  port (
    clk : in std_ulogic;
    advance : in std_ulogic;
    count : out unsigned(3 downto 0) := (others => '0');
    wraps : out std_ulogic
  );
end entity;

architecture rtl of counter is
  signal rounds : unsigned(1 downto 0) := (others => '0');
begin

  wraps <= '1' when count >= 5 else '0';

  work : process
  begin
    wait until rising_edge(clk);
    if advance then
      count <= count + 1;
      if wraps then
        count <= (others => '0');
        rounds <= rounds + 1;
      end if;
    end if;
  end process;

end architecture;
)";

const std::string properties = R"(vunit counter_properties (counter(rtl)) {
  default clock is rising_edge(clk);
  count_stays_below_six : assert always (count < 6);
}
)";

const std::string bench = R"(library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity counter_tb is
end entity;

architecture tb of counter_tb is
  signal clk, wraps : std_ulogic := '0';
  signal count : unsigned(3 downto 0);
begin
  clk <= not clk after 5 ns;
  uut : entity work.counter
    port map (clk => clk, advance => '1', count => count, wraps => wraps);
  check : process
  begin
    for clock in 1 to 4 loop
      wait until rising_edge(clk);
      assert count = clock - 1 severity failure;
    end loop;
    wait until count = 4;
    std.env.finish;
  end process;
end architecture;
)";

class Judging : public testing::Test {
 protected:
  Judging() {
    folder_.write("testbench/counter_tb.vhd", bench);
    std::filesystem::create_directories(folder_.path() / "work" / "trial");
    proof::Proof below;
    below.name = "below_six";
    below.method = proof::Method::induction;
    below.depth = 1;
    below.entity = "counter";
    list_.proofs = {below};
    judges_ = std::make_unique<proof::Judges>(
        proof::Folders{folder_.path(), folder_.path() / "work"}, list_);
  }

  proof::Variant variant(const std::string& from, const std::string& to) const {
    const auto replaced = [&](std::string text) {
      text.replace(text.find(from), from.size(), to);
      return text;
    };
    return {"counter", replaced(judges_->sources.simulated().text_of("counter")),
            replaced(judges_->sources.synthesized().text_of("counter"))};
  }
  Finding by_bench(const std::string& from, const std::string& to) {
    return judges_->benches.ask("counter_tb", variant(from, to), trial_).finding;
  }
  Finding by_comparison(const std::string& from, const std::string& to) {
    return judges_->netlists.ask(variant(from, to), trial_).finding;
  }
  Finding by_proof(const std::string& from, const std::string& to) {
    return judges_->proofs.ask(list_.proofs.front(), variant(from, to), trial_).finding;
  }

  CounterFolder folder_{counter, properties};
  proof::List list_;
  std::unique_ptr<proof::Judges> judges_;
  std::filesystem::path trial_ = folder_.path() / "work" / "trial";
};

TEST_F(Judging, a_bench_kills_what_it_sees_and_passes_the_rest) {
  EXPECT_EQ(by_bench("count + 1", "count + 2"), Finding::killed);
  EXPECT_EQ(by_bench("count >= 5", "count >= 6"), Finding::passes);
}

TEST_F(Judging, a_bench_that_never_ends_kills) {
  EXPECT_EQ(by_bench("count >= 5", "count >= 3"), Finding::killed);
}

TEST_F(Judging, what_never_settles_is_killed) {
  EXPECT_EQ(by_bench("'1' when count >= 5", "not wraps when count >= 3"), Finding::killed);
}

TEST_F(Judging, what_does_not_compile_is_refused_by_all) {
  EXPECT_EQ(by_bench("count >= 5", "count >= clk"), Finding::refused);
  EXPECT_EQ(by_comparison("count >= 5", "count >= clk"), Finding::refused);
}

TEST_F(Judging, netlists_with_the_same_behaviour_are_equivalent) {
  EXPECT_EQ(by_comparison("if wraps then", "if wraps and advance then"), Finding::equivalent);
  EXPECT_EQ(by_comparison("if wraps then", "if wraps and not advance then"), Finding::passes);
}

TEST_F(Judging, what_is_proved_of_the_original_counts) {
  EXPECT_EQ(by_comparison("count >= 5", "count = 5"), Finding::equivalent);
}

TEST_F(Judging, a_package_is_compared_in_all_that_use_it) {
  folder_.write("rtl/numbers_pkg.vhd", R"(package numbers_pkg is
  constant of_one : natural := 1;
  constant of_two : natural := 2;
  constant of_none : natural := 3;
end package;
)");
  for (const std::string name : {"one", "two"}) {
    folder_.write("rtl/" + name + ".vhd",
                  "use work.numbers_pkg.all;\nentity " + name +
                      " is port (number : out natural range 0 to 15); end entity;\narchitecture "
                      "rtl of " +
                      name + " is\nbegin\n  number <= of_" + name + ";\nend architecture;\n");
  }
  proof::Judges judges(proof::Folders{folder_.path(), folder_.path() / "work"}, list_);
  const auto by_comparison_of = [&](const std::string& from, const std::string& to) {
    std::string text = judges.sources.synthesized().text_of("numbers_pkg");
    text.replace(text.find(from), from.size(), to);
    return judges.netlists.ask({"numbers_pkg", text, text}, trial_).finding;
  };
  EXPECT_EQ(by_comparison_of("natural := 1", "natural := 4"), Finding::passes);
  EXPECT_EQ(by_comparison_of("natural := 2", "natural := 4"), Finding::passes);
  EXPECT_EQ(by_comparison_of("natural := 3", "natural := 4"), Finding::equivalent);
}

TEST_F(Judging, another_start_is_no_equivalence) {
  EXPECT_EQ(by_comparison("count : out unsigned(3 downto 0) := (others => '0')",
                          "count : out unsigned(3 downto 0) := (others => '1')"),
            Finding::passes);
}

TEST_F(Judging, a_proof_kills_what_breaks_its_property_from_the_start) {
  EXPECT_EQ(by_proof("count >= 5", "count >= 6"), Finding::killed);
  EXPECT_EQ(by_proof("count >= 5", "count >= 4"), Finding::passes);
}

TEST_F(Judging, the_key_of_a_judge_is_made_of_all_that_it_depends_on) {
  const auto one = variant("count + 1", "count + 2");
  const auto other = variant("count + 1", "count + 3");
  EXPECT_EQ(judges_->benches.key("counter_tb", one), judges_->benches.key("counter_tb", one));
  EXPECT_NE(judges_->benches.key("counter_tb", one), judges_->benches.key("counter_tb", other));
  EXPECT_NE(judges_->netlists.key(one), judges_->netlists.key(other));
}

TEST_F(Judging, benches_and_proofs_are_found_by_what_they_contain) {
  EXPECT_THAT(judges_->benches.own_benches("counter"), ElementsAre("counter_tb"));
  EXPECT_THAT(judges_->benches.other_benches("counter"), ElementsAre());
  EXPECT_EQ(judges_->proofs.proofs_of("counter").size(), 1u);
}

}  // namespace
