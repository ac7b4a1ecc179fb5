// SPDX-License-Identifier: Apache-2.0
// The digest of a trial changes with everything that can change its verdict, and with nothing else.
#include "tools/proof/dependence.hpp"

#include <gmock/gmock.h>

#include "directories.hpp"
#include "tests/proof/small_project.hpp"
#include "tools/proof/task.hpp"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Digests = std::map<std::string, std::optional<std::string>>;

const proof::Versions versions{"ghdl 1", "yosys 1", "z3 1"};
const std::string mutations = "testbench/proofs/parts/mutations/all.toml";
const std::string proofs = "testbench/proofs/parts/proofs/all.toml";

Digests digests_of(const std::filesystem::path& project, const std::filesystem::path& work,
                   const proof::Versions& tools) {
  std::filesystem::remove_all(work);
  std::filesystem::create_directories(work);
  const proof::Folders folders{project, work};
  const proof::List list = proof::read_list(folders.list());
  const proof::Dependence dependence(folders, tools);
  Digests digests;
  for (const proof::Proof& proof : list.proofs) {
    digests[proof.name] = dependence.digest_of(proof, nullptr);
  }
  for (const proof::Mutation& mutation : list.mutations) {
    const auto proof = std::ranges::find(list.proofs, mutation.proof, &proof::Proof::name);
    digests[mutation.name] = dependence.digest_of(*proof, &mutation);
  }
  return digests;
}

class Dependence : public testing::Test {
 protected:
  Digests digests(const proof::Versions& tools = versions) const {
    return digests_of(project_.path(), project_.path() / "work", tools);
  }
  // The trials whose digests are others than at first.
  std::vector<std::string> changed(const proof::Versions& tools = versions) const {
    std::vector<std::string> names;
    for (const auto& [name, digest] : digests(tools)) {
      if (digest != before_.at(name)) names.push_back(name);
    }
    return names;
  }
  std::vector<std::string> changed_by(const std::string& file, const std::string& from,
                                      const std::string& to) const {
    project_.change(file, from, to);
    const std::vector<std::string> names = changed();
    project_.change(file, to, from);
    return names;
  }

  SmallProject project_;
  Digests before_ = digests();
};

TEST_F(Dependence, is_known_of_every_trial_and_the_same_each_time) {
  for (const auto& [name, digest] : before_) EXPECT_TRUE(digest) << name;
  EXPECT_THAT(changed(), IsEmpty());
}

TEST_F(Dependence, is_on_one_character_of_a_source_and_of_all_that_it_uses) {
  EXPECT_THAT(changed_by("rtl/counter.vhd", "'0');\n    end if", "'1');\n    end if"),
              ElementsAre("counter", "counter_bench", "counter_stood_in_for",
                          "counts_not_far_enough", "counts_too_far"));
  EXPECT_THAT(changed_by("rtl/limits_pkg.vhd", ":= 5", ":= 6"),
              ElementsAre("counter", "counter_bench", "counts_not_far_enough", "counts_too_far"));
  EXPECT_THAT(changed_by("rtl/latch.vhd", "'0'\n", "'1'\n"), ElementsAre("forgets", "latch"));
  EXPECT_THAT(changed_by("testbench/counter_tb.vhd", "1 to 12", "1 to 13"),
              ElementsAre("counter_bench", "counts_not_far_enough"));
}

TEST_F(Dependence, is_on_properties_and_on_whether_they_are_simulated) {
  EXPECT_THAT(changed_by("testbench/proofs/parts/counter.psl", "< 6", "< 7"),
              ElementsAre("counter", "counter_bench", "counter_stood_in_for",
                          "counts_not_far_enough", "counts_too_far"));
  EXPECT_THAT(changed_by("testbench/proofs/parts/counter.psl", "What counts", "Not for simulation"),
              ElementsAre("counter_bench", "counts_not_far_enough"));
  EXPECT_THAT(changed_by("rtl/latch.vhd", "-> next is_set", "-> next set"),
              ElementsAre("forgets", "latch"))
      << "in a comment that goes on from another one";
}

TEST_F(Dependence, is_not_on_comments_and_space) {
  EXPECT_THAT(changed_by("rtl/counter.vhd", "-- It counts.", "-- It counts on.\n\n"), IsEmpty());
  EXPECT_THAT(changed_by("rtl/counter.vhd", "count + 1;", "count  + 1; -- more"), IsEmpty());
  EXPECT_THAT(changed_by(proofs, "it stays low", "it stays below six"), IsEmpty());
  EXPECT_THAT(changed_by(proofs, "quick = true", "quick = false"), IsEmpty());
}

TEST_F(Dependence, is_on_comments_that_may_be_for_a_tool) {
  EXPECT_THAT(changed_by("rtl/latch.vhd", "begin\n\n", "begin -- synthesis translate_off\n\n"),
              ElementsAre("forgets", "latch"));
}

TEST_F(Dependence, is_on_stand_ins_and_lemmas) {
  EXPECT_THAT(changed_by("testbench/proofs/parts/limits_pkg.vhdl", ":= 5", ":= 6"),
              ElementsAre("counter_stood_in_for"));
  EXPECT_THAT(changed_by("testbench/proofs/parts/sum.smt2", "(+ x x)", "(- x x)"),
              ElementsAre("sum", "sum_of_three"));
}

TEST_F(Dependence, is_on_the_settings_of_a_proof_and_of_a_mutation) {
  EXPECT_THAT(changed_by(proofs, "{sets = 1}", "{sets = 2}"), ElementsAre("forgets", "latch"));
  EXPECT_THAT(changed_by(proofs, "\"bounded\"\ndepth = 3\ng", "\"bounded\"\ndepth = 4\ng"),
              ElementsAre("forgets", "latch"));
  EXPECT_THAT(changed_by(proofs, "depth = 1\nq", "depth = 1\nexcept = [\"x\"]\nq"),
              ElementsAre("counter", "counts_too_far"));
  EXPECT_THAT(changed_by(mutations, "last + 1", "last + 2"), ElementsAre("counts_too_far"));
  EXPECT_THAT(changed_by(mutations, "depth = 4", "depth = 5"), ElementsAre("forgets"));
  EXPECT_THAT(changed_by(mutations, "\"it_stays_set\"", "\"it_stays\""), ElementsAre("forgets"));
}

TEST_F(Dependence, is_on_the_versions_of_the_tools_that_judge) {
  const std::vector<std::string> benches{"counter_bench", "counts_not_far_enough"};
  const std::vector<std::string> lemmas{"sum", "sum_of_three"};
  for (const auto& [name, digest] : digests({"ghdl 2", "yosys 1", "z3 1"})) {
    EXPECT_EQ(digest != before_.at(name), std::ranges::find(lemmas, name) == lemmas.end()) << name;
  }
  for (const auto& [name, digest] : digests({"ghdl 1", "yosys 2", "z3 1"})) {
    const bool is_by_solver = std::ranges::find(lemmas, name) == lemmas.end() &&
                              std::ranges::find(benches, name) == benches.end();
    EXPECT_EQ(digest != before_.at(name), is_by_solver) << name;
  }
  for (const auto& [name, digest] : digests({"ghdl 1", "yosys 1", "z3 2"})) {
    EXPECT_EQ(digest != before_.at(name), std::ranges::find(benches, name) == benches.end())
        << name;
  }
}

TEST_F(Dependence, is_on_all_programs_that_take_part_in_a_verdict) {
  const std::size_t all = before_.size();
  for (const char* file :
       {"tools/proof/task.cpp", "tools/proof/task.hpp", "tools/proof/workspace.cpp",
        "tools/proof/formal_netlist.cpp", "tools/proof/solver_log.cpp", "tools/proof/bench.cpp",
        "tools/proof/mutation.cpp", "tools/proof/source_tree.cpp", "tools/proof/process.hpp"}) {
    const std::string first = "// SPDX-License-Identifier: Apache-2.0\n";
    project_.change(file, first, first + "\n");
    EXPECT_EQ(changed().size(), all) << file;
    project_.change(file, first + "\n", first);
  }
  project_.change("tools/hardware/weave_properties.sh", "set -euo", "set -uo");
  EXPECT_EQ(changed().size(), all);
  project_.change("tools/hardware/weave_properties.sh", "set -uo", "set -euo");
  EXPECT_THAT(changed_by("tools/proof/report.cpp", "Table lines", "Lines"), IsEmpty());
  project_.change("tools/process/process.cpp", "Apache-2.0\n", "Apache-2.0\n\n");
  EXPECT_THAT(changed(), IsEmpty());
}

TEST_F(Dependence, is_unknown_where_a_mutation_does_not_apply) {
  project_.change("rtl/latch.vhd", "if set then", "if set = '1' then");
  EXPECT_EQ(digests().at("forgets"), std::nullopt);
}

TEST_F(Dependence, is_on_what_a_mutation_brings_in) {
  project_.write("rtl/other_pkg.vhd",
                 "package other_pkg is\n  constant last : natural := 6;\nend;\n");
  project_.change(mutations, "last + 1", "work.other_pkg.last");
  const auto before = digests().at("counts_too_far");
  project_.change("rtl/other_pkg.vhd", ":= 6", ":= 7");
  EXPECT_NE(digests().at("counts_too_far"), before);
}

TEST_F(Dependence, is_on_all_that_a_trial_sees) {
  // The trial gets the files of the digest and no others: what escapes the one escapes both.
  project_.write("rtl/hidden.vhd", "package revealed is\n  constant last : natural := 5;\nend;\n");
  project_.change("rtl/counter.vhd", "work.limits_pkg.all", "work.revealed.all");
  const proof::Folders folders{project_.path(), project_.path() / "work"};
  const proof::List list = proof::read_list(folders.list());
  prepare_sources(folders, folders.work / "sources", nullptr);
  const proof::Outcome outcome =
      try_proof(folders, list.proofs.front(), folders.work / "sources", std::chrono::seconds(60));
  EXPECT_EQ(outcome.verdict, proof::Verdict::broken);
}

TEST(dependence, is_known_of_all_proofs_and_mutations_of_the_chip) {
  const TemporaryFolder folder;
  for (const auto& [name, digest] : digests_of(PROJECT_DIRECTORY, folder.path(), versions)) {
    EXPECT_TRUE(digest) << name;
  }
}

}  // namespace
