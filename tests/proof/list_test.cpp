// SPDX-License-Identifier: Apache-2.0
// The list of proofs: read completely or refused.
#include "tools/proof/list.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/temporary_folder.hpp"

namespace {

const std::string a_proof = R"([[proof]]
name = "latch"
says = "it latches"
entity = "latch"
by = "induction"
depth = 2
generics = {axes = 3}
only = ["one"]
)";
const std::string a_mutation = R"([[mutation]]
name = "m"
file = "rtl/latch.vhd"
from = "a"
to = "b"
proof = "latch"
property = "one"
)";

void expect_refused(const std::string& proofs, const std::string& mutations) {
  const TemporaryFolder folder;
  folder.write("part/proofs/latch.toml", proofs);
  folder.write("part/mutations/latch.toml", mutations);
  EXPECT_THROW(proof::read_list(folder.path()), std::runtime_error) << proofs << mutations;
}

TEST(list, says_what_is_to_be_proved_and_broken) {
  const TemporaryFolder folder;
  folder.write("part/proofs/latch.toml", a_proof);
  folder.write("part/mutations/latch.toml", a_mutation);
  const proof::List list = proof::read_list(folder.path());
  ASSERT_EQ(list.proofs.size(), 1u);
  EXPECT_EQ(list.proofs[0].method, proof::Method::induction);
  EXPECT_EQ(list.proofs[0].depth, 2);
  EXPECT_EQ(list.proofs[0].generics.at("axes"), "3");
  ASSERT_EQ(list.mutations.size(), 1u);
  EXPECT_EQ(list.mutations[0].property, "one");
}

TEST(list, refuses_what_it_does_not_know_or_misses) {
  expect_refused(a_proof + "depht = 3\n", a_mutation);
  expect_refused(a_proof + a_proof, a_mutation);
  expect_refused("[[proof]]\nname = \"x\"\n", a_mutation);
  expect_refused(a_proof, a_mutation + "[[mutation]]\nname = \"n\"\n");
  expect_refused("not toml", a_mutation);
}

TEST(list, is_that_of_all_folders_together) {
  const TemporaryFolder folder;
  folder.write("part/proofs/latch.toml", a_proof);
  folder.write("part/mutations/latch.toml", a_mutation);
  std::string other = a_mutation;
  other.replace(other.find("\"m\""), 3, "\"other\"");
  folder.write("part/mutations/other.toml", other);
  std::string third = a_mutation;
  third.replace(third.find("\"m\""), 3, "\"third\"");
  folder.write("whole/mutations/latch.toml", third);
  folder.write("whole/mutations/README.md", "no list");
  EXPECT_EQ(proof::read_list(folder.path()).mutations.size(), 3u);
  folder.write("part/mutations/other.toml", a_mutation);
  EXPECT_THROW(proof::read_list(folder.path()), std::runtime_error) << "the same name twice";
}

TEST(list, knows_benches_which_break_as_a_whole) {
  const std::string bench =
      "[[proof]]\nname = \"latch\"\nsays = \"it latches\"\n"
      "entity = \"latch_tb\"\nby = \"bench\"\n";
  std::string mutation = a_mutation;
  expect_refused(bench, mutation);
  mutation.erase(mutation.find("property"));
  expect_refused(a_proof, mutation);
  const TemporaryFolder folder;
  folder.write("part/proofs/latch.toml", bench);
  folder.write("part/mutations/latch.toml", mutation);
  const proof::List list = proof::read_list(folder.path());
  EXPECT_EQ(list.proofs.at(0).method, proof::Method::bench);
  EXPECT_EQ(list.proofs.at(0).entity, "latch_tb");
}

TEST(list, knows_faults_of_a_lemma_itself_and_of_no_other_file) {
  const std::string lemma =
      "[[proof]]\nname = \"latch\"\nsays = \"a sum\"\nby = \"arithmetic\"\n"
      "lemma = \"part/sum.smt2\"\n";
  std::string mutation = a_mutation;
  mutation.erase(mutation.find("property"));
  expect_refused(lemma, mutation);
  mutation.replace(mutation.find("rtl/latch.vhd"), 13, "proofs/part/sum.smt2");
  expect_refused(lemma, mutation + "property = \"one\"\n");
  const TemporaryFolder folder;
  folder.write("part/proofs/latch.toml", lemma);
  folder.write("part/mutations/latch.toml", mutation);
  EXPECT_EQ(proof::read_list(folder.path()).mutations.size(), 1u);
}

TEST(list, refuses_a_mutation_of_a_proof_that_is_not_there) {
  std::string mutation = a_mutation;
  mutation.replace(mutation.find("\"latch\""), 7, "\"other\"");
  expect_refused(a_proof, mutation);
  const TemporaryFolder folder;
  folder.write("part/proofs/latch.toml", a_proof);
  folder.write("part/mutations/latch.toml", mutation);
  try {
    proof::read_list(folder.path());
    FAIL() << "a mutation of an unknown proof was read";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("part/mutations/latch.toml: m: "));
  }
}

}  // namespace
