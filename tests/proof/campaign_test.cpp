// SPDX-License-Identifier: Apache-2.0
// What counts, what is good enough, what is out of date, what is kept.
#include "tools/proof/campaign.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "directories.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/proof/campaign_report.hpp"
#include "tools/proof/campaign_summary.hpp"
#include "tools/proof/findings.hpp"
#include "tools/proof/process.hpp"
#include "tools/proof/source_tree.hpp"

namespace {

using proof::Fate;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

proof::MutantOutcome outcome(const std::string& id, Fate fate, bool is_listed = false) {
  proof::MutantOutcome outcome;
  outcome.unit = "part";
  outcome.mutant.id = id;
  outcome.fate = fate;
  outcome.is_listed = is_listed;
  return outcome;
}

std::vector<proof::MutantOutcome> killed(int number) {
  return std::vector<proof::MutantOutcome>(static_cast<std::size_t>(number),
                                           outcome("k", Fate::killed));
}

TEST(campaign, counts_neither_equivalent_mutants_nor_refused_ones) {
  const auto count = proof::count(
      {outcome("a", Fate::killed), outcome("b", Fate::surviving), outcome("c", Fate::refused),
       outcome("d", Fate::proved_equivalent), outcome("e", Fate::judged_equivalent)});
  EXPECT_EQ(count.counted(), 2);
  EXPECT_DOUBLE_EQ(count.score(), 0.5);
}

TEST(campaign, is_good_from_97_percent_on_where_every_survivor_is_listed) {
  auto outcomes = killed(97);
  for (const char* id : {"a", "b", "c"}) outcomes.push_back(outcome(id, Fate::surviving, true));
  EXPECT_TRUE(proof::is_good(outcomes, {}, false));
  outcomes.push_back(outcome("d", Fate::surviving, true));
  EXPECT_FALSE(proof::is_good(outcomes, {}, false));
  EXPECT_TRUE(proof::is_good(outcomes, {}, true)) << "a sample may be unlucky";
}

TEST(campaign, is_not_good_with_a_survivor_that_is_not_listed) {
  auto outcomes = killed(1000);
  outcomes.push_back(outcome("a", Fate::surviving));
  EXPECT_FALSE(proof::is_good(outcomes, {}, false));
  EXPECT_FALSE(proof::is_good(outcomes, {}, true));
}

TEST(campaign, is_not_good_with_an_entry_out_of_date) {
  EXPECT_FALSE(proof::is_good(killed(10), {"one"}, true));
}

TEST(campaign, reports_the_entries_that_are_out_of_date) {
  const proof::Judgement judgement{proof::Judgement::Kind::equivalent, "because"};
  const std::map<std::string, proof::Judgement> judgements{
      {"a", judgement}, {"b", judgement}, {"c", judgement}, {"d", judgement}};
  EXPECT_THAT(proof::stale_entries(
                  judgements, {"a", "b", "c"},
                  {outcome("a", Fate::killed), outcome("b", Fate::judged_equivalent, true)}),
              ElementsAre(HasSubstr("no such mutant is made: d"), HasSubstr("is killed ()")));
}

// A solver has a time limit: a fast machine proves what a slow one leaves to the reason
// in the list.
TEST(campaign, takes_a_proof_of_a_judgement_as_agreement) {
  const std::map<std::string, proof::Judgement> judgements{
      {"a", {proof::Judgement::Kind::equivalent, "because"}},
      {"b", {proof::Judgement::Kind::surviving, "no bench reaches it"}}};
  EXPECT_THAT(proof::stale_entries(
                  judgements, {"a", "b"},
                  {outcome("a", Fate::proved_equivalent), outcome("b", Fate::proved_equivalent)}),
              IsEmpty());
}

TEST(campaign, takes_the_same_sample_for_the_same_seed) {
  const auto sample = proof::sample_of(1000, 40, 7);
  EXPECT_THAT(sample, SizeIs(40));
  EXPECT_TRUE(std::ranges::is_sorted(sample));
  EXPECT_EQ(std::ranges::adjacent_find(sample), sample.end());
  EXPECT_EQ(sample, proof::sample_of(1000, 40, 7));
  EXPECT_NE(sample, proof::sample_of(1000, 40, 8));
  EXPECT_THAT(proof::sample_of(3, 0, 7), ElementsAre(0, 1, 2));
}

TEST(judgements, need_a_reason_and_stand_there_once) {
  const TemporaryFolder folder;
  EXPECT_THAT(proof::read_judgements(folder.path() / "none"), IsEmpty());
  folder.write("part.toml",
               "[[equivalent]]\nmutants = [\"a\", \"b\"]\nreason = \"because\"\n"
               "[[surviving]]\nmutants = [\"c\"]\nreason = \"no bench reaches it\"\n");
  const auto judgements = proof::read_judgements(folder.path());
  EXPECT_EQ(judgements.at("b").kind, proof::Judgement::Kind::equivalent);
  EXPECT_EQ(judgements.at("c").kind, proof::Judgement::Kind::surviving);
  folder.write("other.toml", "[[surviving]]\nmutants = [\"a\"]\nreason = \"again\"\n");
  EXPECT_THROW(proof::read_judgements(folder.path()), std::runtime_error);
  for (const char* text :
       {"[[equivalent]]\nmutants = [\"x\"]\n", "[[equal]]\nmutants = [\"x\"]\nreason = \"y\"\n",
        "[[equivalent]]\nmutants = []\nreason = \"y\"\n",
        "[[equivalent]]\nmutants = [\"x\"]\nreason = \"y\"\nby = \"z\"\n", "[[equivalent]\n"}) {
    folder.write("other.toml", text);
    EXPECT_THROW(proof::read_judgements(folder.path()), std::runtime_error) << text;
  }
}

TEST(findings, last_and_do_not_hold_half_a_line) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "findings.txt";
  {
    proof::Findings findings(file);
    EXPECT_FALSE(findings.find("k").has_value());
    findings.add("k", {proof::Finding::killed, "part_tb\nat once"});
  }
  std::ofstream(file, std::ios::app) << "half passes by_th";
  proof::Findings findings(file);
  ASSERT_TRUE(findings.find("k").has_value());
  EXPECT_EQ(findings.find("k")->finding, proof::Finding::killed);
  EXPECT_EQ(findings.find("k")->detail, "part_tb at once");
  EXPECT_FALSE(findings.find("half").has_value());
}

TEST(findings, keeps_no_verdict_of_a_judge_that_had_too_little_time) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "findings.txt";
  {
    proof::Findings findings(file);
    findings.add("k", {proof::Finding::passes, "not decided in time", true});
    EXPECT_TRUE(findings.find("k").has_value());
  }
  EXPECT_FALSE(proof::Findings(file).find("k").has_value());
}

TEST(source_tree, knows_what_a_unit_needs) {
  const TemporaryFolder folder;
  folder.write("rtl/a.vhd", "use work.b_pkg.all; -- work.d\n");
  folder.write("rtl/b_pkg.vhd", "use work.c.all;");
  folder.write("rtl/c.vhd", "");
  folder.write("rtl/d.vhd", "use work.a;");
  const proof::SourceTree tree({folder.path() / "rtl"});
  EXPECT_THAT(tree.closure_of("a"), ElementsAre("a", "b_pkg", "c"));
  EXPECT_THROW(tree.file_of("e"), std::runtime_error);
}

TEST(fingerprint, differs_where_texts_differ) {
  EXPECT_EQ(proof::fingerprint("text"), proof::fingerprint("text"));
  EXPECT_NE(proof::fingerprint("text"), proof::fingerprint("texu"));
  EXPECT_EQ(proof::fingerprint("").size(), 32u);
}

TEST(campaign, records_what_was_tried_of_a_file_and_what_was_not) {
  const TemporaryFolder folder;
  auto survivor = outcome("part: b", Fate::surviving);
  auto dead = outcome("part: a", Fate::killed);
  dead.by = "part_tb";
  proof::record_campaign(folder.path(), {dead, survivor},
                         {"part: a", "part: b", "part: c", "other: a"});
  EXPECT_EQ(proof::text_of(folder.path() / "part.tsv"),
            "killed\tpart_tb\tpart: a\nsurviving\tall judges\tpart: b\nnot tried\t\tpart: c\n");
  EXPECT_EQ(proof::text_of(folder.path() / "other.tsv"), "not tried\t\tother: a\n");
  EXPECT_THAT(proof::mutants_listed_as(proof::not_tried, folder.path()),
              ElementsAre("other: a", "part: c"));
  EXPECT_THAT(proof::mutants_listed_as(proof::name_of(Fate::surviving), folder.path()),
              ElementsAre("part: b"));
  proof::record_campaign(folder.path(), {survivor}, {"part: b", "other: a", "other: b"});
  EXPECT_EQ(proof::text_of(folder.path() / "other.tsv"), "not tried\t\tother: a\n")
      << "stays as it was";
  EXPECT_THAT(proof::mutants_listed_as(proof::not_tried, folder.path() / "nothing"), IsEmpty());
}

TEST(campaign, keeps_in_its_lists_what_was_found_before_where_that_is_asked_for) {
  const TemporaryFolder folder;
  folder.write("part.tsv",
               "killed\tpart_tb\tpart: a\nnot tried\t\tpart: b\nnot tried\t\tpart: c\n"
               "killed\tpart_tb\tpart: gone\n");
  auto dead = outcome("part: b", Fate::killed);
  dead.by = "other_tb";
  const std::vector<std::string> made{"part: a", "part: b", "part: c", "part: new"};
  proof::record_campaign(folder.path(), {dead}, made, true);
  EXPECT_EQ(proof::text_of(folder.path() / "part.tsv"),
            "killed\tpart_tb\tpart: a\nkilled\tother_tb\tpart: b\nnot tried\t\tpart: c\n"
            "not tried\t\tpart: new\n");
  proof::record_campaign(folder.path(), {dead}, made);
  EXPECT_EQ(proof::text_of(folder.path() / "part.tsv"),
            "not tried\t\tpart: a\nkilled\tother_tb\tpart: b\nnot tried\t\tpart: c\n"
            "not tried\t\tpart: new\n");
}

TEST(results, have_a_row_for_each_list_and_name_the_survivors) {
  const TemporaryFolder folder;
  folder.write("part.tsv",
               "killed\tpart_tb\tpart: a\nkilled\tpart_tb\tpart: b\nkilled\tpart_tb\tpart: c\n"
               "surviving\tall judges\tpart: d\nrefused\t\tpart: e\nnot tried\t\tpart: f\n"
               "judged equivalent\t\tpart: g\nproved equivalent\t\tpart: h\n");
  folder.write("other.tsv", "not tried\t\tother: a\n");
  const std::string text = proof::summary_of(folder.path());
  EXPECT_THAT(text, HasSubstr("| `other` | 1 | 1 | 0 | 0 | 0 | 0 |  |\n"
                              "| `part` | 8 | 1 | 1 | 3 | 2 | 1 | 75.0 % |\n"
                              "| **all** | 9 | 2 | 1 | 3 | 2 | 1 | 75.0 % |\n"));
  EXPECT_THAT(text, HasSubstr("    part: d (all judges)\n"));
  folder.write("part.tsv", "died\t\tpart: a\n");
  EXPECT_THROW(proof::summary_of(folder.path()), std::runtime_error);
  folder.write("part.tsv", "killed\n");
  EXPECT_THROW(proof::summary_of(folder.path()), std::runtime_error);
}

TEST(results, are_written_with_the_lists) {
  const TemporaryFolder folder;
  proof::record_campaign(folder.path(), {outcome("part: a", Fate::killed)}, {"part: a"});
  EXPECT_EQ(proof::text_of(folder.path() / "RESULTS.md"), proof::summary_of(folder.path()));
}

TEST(results, of_the_project_are_those_of_its_lists) {
  const auto folder = std::filesystem::path(PROJECT_DIRECTORY) / "testbench" / "proofs" / "mutants";
  EXPECT_EQ(proof::text_of(folder / "RESULTS.md"), proof::summary_of(folder))
      << "write it with `./stepfabric prove --mutants FILE --quick --record`";
}

}  // namespace
