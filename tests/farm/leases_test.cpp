// SPDX-License-Identifier: Apache-2.0
// Two spoolers on one queue: who has which printer, and what the other one may not do.
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"

namespace {

using namespace queue;
using namespace std::chrono_literals;
using farm_test::open_farm;
using testing::HasSubstr;

constexpr auto lease_time = 1000ms;

class Leases : public testing::Test {
 protected:
  JobId checked(const std::string& name, const std::string& printer = "") {
    NewJob job = farm_test::uploaded(address, name);
    job.wanted_printer = printer;
    const JobId id = a.add(job);
    a.change(id, JobState::checking, "");
    a.change(id, JobState::queued, "");
    return id;
  }
  JobId started(Queue& by, const std::string& name) {
    const JobId id = checked(name);
    EXPECT_EQ(by.claim("left"), "");
    by.set_bed_clear("left", true);
    by.start(id, "left");
    return id;
  }
  void let_it_end() const { std::this_thread::sleep_for(lease_time + 200ms); }

  std::string address = farm_test::shared_server().new_database();
  Queue a = open_farm(address, "a", lease_time), b = open_farm(address, "b", lease_time);
};

TEST_F(Leases, a_printer_belongs_to_one_spooler_and_the_other_hears_which) {
  EXPECT_EQ(a.claim("left"), "");
  const std::string refusal = b.claim("left");
  EXPECT_THAT(refusal, HasSubstr("left belongs to the spooler on machine of a"));
  EXPECT_FALSE(b.holds("left"));
  EXPECT_EQ(b.claim("right"), "");
  const JobId id = checked("job");
  EXPECT_THROW(b.set_bed_clear("left", true), LeaseLost);
  a.set_bed_clear("left", true);
  EXPECT_THROW(b.start(id, "left"), LeaseLost);
  EXPECT_NO_THROW(a.start(id, "left"));
  EXPECT_THROW(b.change(id, JobState::printing, ""), LeaseLost);
  EXPECT_THROW(b.take_back(id, ""), LeaseLost);
}

TEST_F(Leases, one_that_is_renewed_does_not_end) {
  EXPECT_EQ(a.claim("left"), "");
  for (int i = 0; i < 8; ++i) {
    std::this_thread::sleep_for(lease_time / 4);
    a.renew();
    EXPECT_NE(b.claim("left"), "") << i;
  }
  EXPECT_TRUE(a.holds("left"));
}

TEST_F(Leases, after_its_end_another_spooler_gets_it_and_the_first_writes_nothing_more) {
  const JobId id = started(a, "job");
  a.change(id, JobState::printing, "");
  let_it_end();
  EXPECT_THROW(a.change(id, JobState::finished, ""), LeaseLost) << "not even before b has it";
  EXPECT_EQ(b.claim("left"), "");
  EXPECT_EQ(b.find(id)->state, JobState::interrupted) << "b cannot know how far it is";
  EXPECT_THAT(b.find(id)->reason, HasSubstr("machine of a"));
  EXPECT_FALSE(b.bed_is_clear("left"));
  const JobId next = checked("next");
  b.set_bed_clear("left", true);
  EXPECT_THROW(a.start(next, "left"), LeaseLost);
  a.renew();
  EXPECT_FALSE(a.holds("left"));
  EXPECT_THROW(a.start(next, "left"), LeaseLost);
  EXPECT_THAT(a.claim("left"), HasSubstr("machine of b"));
  EXPECT_NO_THROW(b.start(next, "left"));
}

// It could have been begun by the first one: it is not sent again.
TEST_F(Leases, a_job_that_was_starting_is_interrupted_too) {
  const JobId id = started(a, "job");
  let_it_end();
  EXPECT_EQ(b.claim("left"), "");
  EXPECT_EQ(b.find(id)->state, JobState::interrupted);
  EXPECT_EQ(b.find(id)->starts, 1);
  EXPECT_FALSE(b.next_for("left"));
}

TEST_F(Leases, one_that_has_ended_is_taken_again_where_no_other_one_has_it) {
  const JobId id = started(a, "job");
  let_it_end();
  EXPECT_THROW(a.change(id, JobState::printing, ""), LeaseLost);
  a.renew();
  EXPECT_TRUE(a.holds("left"));
  EXPECT_NO_THROW(a.change(id, JobState::printing, ""));
}

TEST_F(Leases, the_same_spooler_has_it_again_at_once_after_a_crash_with_its_job) {
  const JobId id = started(a, "job");
  a.change(id, JobState::printing, "");
  Queue again = open_farm(address, "a", lease_time);
  EXPECT_EQ(again.claim("left"), "");
  EXPECT_EQ(again.find(id)->state, JobState::printing);
  EXPECT_THROW(a.change(id, JobState::finished, ""), LeaseLost) << "the old process";
  EXPECT_NO_THROW(again.change(id, JobState::finished, ""));
}

// Or a copy of its folder on another machine.
TEST_F(Leases, the_same_folder_on_a_machine_that_was_started_again_waits_for_the_end) {
  const JobId id = started(a, "job");
  EXPECT_THROW(open_farm(address, "a", lease_time, "another boot"), std::runtime_error)
      << "a copy of the whole disk has the number too";
  let_it_end();
  Queue again = open_farm(address, "a", lease_time, "another boot");
  EXPECT_EQ(again.claim("left"), "");
  EXPECT_EQ(again.find(id)->state, JobState::starting) << "its journal knows";
}

TEST_F(Leases, one_that_was_given_back_is_free_at_once_unless_its_printer_prints) {
  EXPECT_EQ(a.claim("right"), "");
  started(a, "job");
  a.release();
  EXPECT_EQ(b.claim("right"), "");
  EXPECT_NE(b.claim("left"), "");
  for (const Lease& lease : b.leases()) EXPECT_EQ(lease.is_mine, lease.printer == "right");
}

TEST_F(Leases, a_job_for_any_printer_is_started_by_one_spooler_and_one_for_a_printer_waits_for_it) {
  const JobId any = checked("any"), named = checked("named", "right");
  EXPECT_EQ(a.claim("left"), "");
  EXPECT_EQ(b.claim("right"), "");
  a.set_bed_clear("left", true);
  b.set_bed_clear("right", true);
  EXPECT_EQ(a.next_for("left")->id, any);
  EXPECT_EQ(b.next_for("right")->id, any);
  EXPECT_TRUE(b.start_if_next(any, "right"));
  EXPECT_FALSE(a.start_if_next(any, "left"));
  EXPECT_FALSE(a.next_for("left")) << "the other one is for another printer";
  EXPECT_THROW(a.start(named, "left"), NotPermitted);
}

TEST_F(Leases, a_check_belongs_to_the_spooler_with_the_upload_until_that_is_away) {
  const JobId id = a.add(farm_test::uploaded(address, "job"));
  EXPECT_TRUE(a.checks().contains(id));
  EXPECT_FALSE(b.checks().contains(id));
  EXPECT_THROW(b.change(id, JobState::checking, ""), NotPermitted);
  a.change(id, JobState::checking, "");
  b.renew();
  EXPECT_THROW(b.change(id, JobState::queued, ""), NotPermitted);
  let_it_end();
  b.renew();
  EXPECT_TRUE(b.checks().contains(id));
  EXPECT_THROW(a.change(id, JobState::queued, ""), NotPermitted);
  EXPECT_NO_THROW(b.change(id, JobState::uploaded, ""));
}

}  // namespace
