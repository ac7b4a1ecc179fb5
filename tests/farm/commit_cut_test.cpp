// SPDX-License-Identifier: Apache-2.0
// The connection is cut in the middle of a COMMIT: what was committed is found out, and nothing is
// done twice.
#include <gtest/gtest.h>

#include <chrono>

#include "host/queue/postgres_database.hpp"
#include "tests/farm/cutting_proxy.hpp"
#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"

namespace {

using namespace queue;
using farm_test::Cut;

class CutCommit : public testing::Test {
 protected:
  std::string direct = farm_test::shared_server().new_database();
  farm_test::CuttingProxy proxy{farm_test::shared_server().socket_folder()};
  Queue jobs{std::make_unique<PostgresDatabase>(farm_test::PostgresServer::address(
                 proxy.socket_folder(), direct.substr(direct.find("dbname=") + 7))),
             {.id = "a", .boot = "1", .place = "here"}};
  Queue watcher{farm_test::open_farm(direct, "watcher")};
  NewJob job = farm_test::uploaded(direct, "part");

  std::size_t count() { return watcher.jobs().size(); }
};

TEST_F(CutCommit, one_that_never_came_is_reported_as_not_done) {
  proxy.cut(Cut::before_commit);
  try {
    jobs.add(job);
    FAIL() << "it was acknowledged";
  } catch (const OutcomeUnknown& error) {
    FAIL() << error.what();
  } catch (const Unavailable&) {
  }
  EXPECT_TRUE(proxy.has_cut());
  EXPECT_EQ(count(), 0u);
  EXPECT_FALSE(jobs.job_of_upload(job.file));
  jobs.add(job);
  EXPECT_EQ(count(), 1u);
}

TEST_F(CutCommit, one_whose_answer_was_lost_is_found_and_not_repeated) {
  proxy.cut(Cut::after_commit);
  const JobId id = jobs.add(job);
  EXPECT_TRUE(proxy.has_cut());
  EXPECT_EQ(count(), 1u);
  EXPECT_EQ(watcher.jobs().at(0).id, id);
}

// What is not there at the first look is there a second later.
TEST_F(CutCommit, one_that_the_server_still_has_to_do_is_waited_for) {
  proxy.cut(Cut::late_commit);
  const JobId id = jobs.add(job);
  EXPECT_TRUE(proxy.has_cut());
  EXPECT_EQ(count(), 1u);
  EXPECT_EQ(watcher.jobs().at(0).id, id);
}

TEST_F(CutCommit, one_that_cannot_be_looked_up_is_unknown_until_it_can) {
  proxy.cut(Cut::after_commit);
  proxy.refuse(true);
  EXPECT_THROW(jobs.add(job), OutcomeUnknown);
  EXPECT_THROW(jobs.jobs(), Unavailable);
  proxy.refuse(false);
  std::optional<JobId> found;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!found && std::chrono::steady_clock::now() < end) {
    try {
      found = jobs.job_of_upload(job.file);
      ASSERT_TRUE(found) << "it was committed";
    } catch (const Unavailable&) {  // a new attempt comes after a while
    }
  }
  EXPECT_EQ(count(), 1u);
}

// The mark of an earlier commit is not taken for that of a later one.
TEST_F(CutCommit, each_commit_has_its_own_outcome) {
  jobs.add(job);
  proxy.cut(Cut::before_commit);
  EXPECT_THROW(jobs.add(job), Unavailable);
  proxy.cut(Cut::after_commit);
  jobs.add(job);
  EXPECT_EQ(count(), 2u);
}

TEST_F(CutCommit, a_network_that_swallows_everything_ends_the_call_and_holds_up_no_other_spooler) {
  proxy.cut(Cut::silence);
  EXPECT_THROW(jobs.add(job), Unavailable);
  watcher.add(job);
  EXPECT_EQ(count(), 1u);
  jobs.add(job);
  EXPECT_EQ(count(), 2u);
}

}  // namespace
