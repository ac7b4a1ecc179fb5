// SPDX-License-Identifier: Apache-2.0
// What is recorded is not tried again, what is stale is, and a wrong record is found by a sample.
#include "tools/proof/records.hpp"

#include <gmock/gmock.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>

#include "tests/proof/small_project.hpp"
#include "tools/files/file_text.hpp"
#include "tools/files/path_lock.hpp"
#include "tools/proof/dependence.hpp"
#include "tools/proof/run.hpp"

namespace {

using proof::Recorded;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class Recording : public testing::Test {
 protected:
  struct Result {
    bool is_good;
    std::set<std::string> tried;
  };
  Result prove(proof::Options options = {}) const {
    options.json = project_.path() / "outcome.json";
    options.jobs = 2;
    Result result{proof::prove(options, project_.path(), project_.path() / "build"), {}};
    const auto json = nlohmann::json::parse(files::text_of(options.json));
    for (const char* kind : {"proofs", "mutations"}) {
      for (const auto& trial : json[kind]) {
        if (trial["tried"]) result.tried.insert(trial["name"].get<std::string>());
      }
    }
    return result;
  }
  static proof::Options recording() {
    proof::Options options;
    options.record = true;
    return options;
  }
  // As a person would who copies digests without trying anything.
  void fake(const std::string& name) const {
    const proof::Folders folders = proof::copied(project_.path(), project_.path() / "fake");
    const proof::List list = proof::read_list(folders.list());
    const auto found = std::ranges::find(list.proofs, name, &proof::Proof::name);
    const proof::Dependence dependence(folders, proof::versions_of_tools(folders.work));
    proof::Records records = proof::read_records(project_.table());
    records[name] = {Recorded::holds, *dependence.digest_of(*found, nullptr)};
    proof::write_records(project_.table(), records);
  }

  SmallProject project_;
};

TEST_F(Recording, spares_what_is_recorded_until_something_that_it_depends_on_changes) {
  EXPECT_THAT(prove().tried, SizeIs(9)) << "nothing is recorded";
  EXPECT_FALSE(std::filesystem::exists(project_.table())) << "nor is it without being asked to";
  EXPECT_TRUE(prove(recording()).is_good);
  EXPECT_THAT(proof::read_records(project_.table()), SizeIs(9));
  const Result nothing = prove();
  EXPECT_TRUE(nothing.is_good);
  EXPECT_THAT(nothing.tried, IsEmpty());
  project_.change("rtl/latch.vhd", "sets : natural := 1", "sets : natural := 2");
  const Result latch = prove();
  EXPECT_TRUE(latch.is_good);
  EXPECT_THAT(latch.tried, ElementsAre("forgets", "latch"));

  proof::Options all;
  all.all = true;
  EXPECT_THAT(prove(all).tried, SizeIs(9));
  proof::Options named;
  named.names = {"sum"};
  EXPECT_THAT(prove(named).tried, ElementsAre("sum"));
  proof::Options quick;
  quick.quick = true;
  EXPECT_THAT(prove(quick).tried, ElementsAre("counter"));
}

TEST_F(Recording, does_not_keep_what_fails) {
  ASSERT_TRUE(prove(recording()).is_good);
  project_.change("rtl/limits_pkg.vhd", ":= 5", ":= 6");
  const Result failing = prove();
  EXPECT_FALSE(failing.is_good);
  EXPECT_TRUE(failing.tried.contains("counter")) << "a stale record is not trusted";
  EXPECT_FALSE(prove(recording()).is_good);
  EXPECT_FALSE(proof::read_records(project_.table()).contains("counter"));
  EXPECT_FALSE(prove().is_good);
}

TEST_F(Recording, of_what_fails_is_found_by_the_sample_that_covers_it) {
  ASSERT_TRUE(prove(recording()).is_good);
  project_.change("testbench/proofs/parts/sum.smt2", "(+ x x)", "(+ x 1)");
  project_.change("testbench/proofs/parts/mutations/all.toml", "(* 3 x)", "(* 4 x)");
  fake("sum");
  EXPECT_TRUE(prove().is_good) << "records alone are believed";
  proof::Options sampling;
  sampling.sample = 3;
  int found = 0;
  for (std::uint64_t seed = 20; seed < 23; ++seed) {
    sampling.seed = seed;
    const Result result = prove(sampling);
    EXPECT_EQ(result.is_good, !result.tried.contains("sum"));
    found += result.is_good ? 0 : 1;
  }
  EXPECT_EQ(found, 1) << "three parts of three: each trial is in one of them";
}

TEST_F(Recording, is_refused_while_another_run_works_in_the_folder) {
  ASSERT_TRUE(prove().is_good);
  const std::filesystem::path folder = project_.path() / "build/proofs";
  const auto files_there = [&folder] {
    return std::distance(std::filesystem::recursive_directory_iterator(folder), {});
  };
  const auto before = files_there();
  std::optional<files::PathLock> other(folder);
  EXPECT_THAT([this] { prove(); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("wait for its end")));
  EXPECT_EQ(files_there(), before) << "the other run's files are still there";
  other.reset();
  EXPECT_TRUE(prove().is_good);
}

TEST_F(Recording, forgets_what_is_not_in_the_lists_any_more) {
  proof::write_records(project_.table(), {{"gone", {Recorded::holds, "0"}}});
  proof::Options options = recording();
  options.names = {"sum"};
  EXPECT_TRUE(prove(options).is_good);
  const proof::Records records = proof::read_records(project_.table());
  EXPECT_THAT(records, SizeIs(1));
  EXPECT_TRUE(records.contains("sum"));
}

TEST(records, are_parted_so_that_seeds_in_a_row_cover_all) {
  const std::vector<std::string> names{"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k"};
  std::multiset<std::string> covered;
  for (std::uint64_t seed = 5; seed < 9; ++seed) {
    for (const std::string& name : proof::part_of(names, 3, seed)) covered.insert(name);
  }
  EXPECT_THAT(covered, testing::ElementsAreArray(names));
  EXPECT_EQ(proof::part_of(names, 3, 1), proof::part_of({names.rbegin(), names.rend()}, 3, 1));
  EXPECT_THAT(proof::part_of(names, 0, 1), IsEmpty());
  EXPECT_THAT(proof::part_of(names, 100, 1), SizeIs(names.size()));
}

TEST(records, are_read_as_written_and_refused_where_a_row_is_none) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "recorded.tsv";
  EXPECT_THAT(proof::read_records(file), IsEmpty());
  const proof::Records records{{"a", {Recorded::holds, "01"}}, {"b", {Recorded::caught, "02"}}};
  proof::write_records(file, records);
  EXPECT_EQ(proof::read_records(file), records);
  for (const char* row : {"a\tholds\n", "a\tfails\t01\n", "\tholds\t01\n", "a\tholds\t01\tmore\n",
                          "a\tholds\t01\na\tholds\t02\n"}) {
    folder.write("recorded.tsv", row);
    EXPECT_THROW(proof::read_records(file), std::runtime_error) << row;
  }
}

}  // namespace
