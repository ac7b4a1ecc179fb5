// SPDX-License-Identifier: Apache-2.0
// On both databases: the queue's states from its table, its order, and that only a free bed lets a
// job start.
#include "host/queue/queue.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace queue;
using testing::ElementsAre;

enum class Kind { sqlite, postgres };

class QueueTest : public testing::TestWithParam<Kind> {
 protected:
  // Also again, as after a restart.
  Queue open() const {
    if (GetParam() == Kind::sqlite) return Queue(folder_.path() / "queue.db");
    return farm_test::open_farm(address_, "spooler");
  }
  JobId add(NewJob job) {
    if (GetParam() == Kind::postgres) farm_test::uploaded(address_, job.name);
    job.file = job.name + ".gcode";
    return jobs.add(job);
  }
  JobId checked(const std::string& name) {
    const JobId id = add({.name = name, .file = {}, .bytes = 7});
    jobs.change(id, JobState::checking, "");
    jobs.change(id, JobState::queued, "");
    return id;
  }
  void start(JobId id, const std::string& printer = "left") {
    if (!jobs.holds(printer)) {
      ASSERT_EQ(jobs.claim(printer), "");
    }
    jobs.set_bed_clear(printer, true);
    jobs.start(id, printer);
  }
  // A job that has come to this state by permitted changes.
  JobId job_in(JobState wanted) {
    std::map<JobState, Transition> way{{JobState::uploaded, {}}};
    while (!way.contains(wanted)) {
      for (const Transition& row : transitions) {
        if (way.contains(row.from)) way.try_emplace(row.to, row);
      }
    }
    std::vector<JobState> steps;
    for (JobState at = wanted; at != JobState::uploaded; at = way[at].from) {
      steps.insert(steps.begin(), at);
    }
    const JobId id = add({.name = "job", .file = {}, .bytes = 7});
    for (const JobState step : steps) go(id, step);
    return id;
  }
  void go(JobId id, JobState to) {
    if (to == JobState::starting) {
      start(id, "printer of " + std::to_string(id));
    } else {
      jobs.change(id, to, "test");
    }
  }
  std::vector<std::string> order() {
    std::vector<std::string> names;
    for (const Job& job : jobs.jobs()) names.push_back(job.name);
    return names;
  }

 private:
  TemporaryFolder folder_;
  std::string address_ =
      GetParam() == Kind::postgres ? farm_test::shared_server().new_database() : "";

 protected:
  void SetUp() override {
    for (const char* printer : {"left", "right"}) ASSERT_EQ(jobs.claim(printer), "");
  }
  Queue jobs{open()};
};

INSTANTIATE_TEST_SUITE_P(on, QueueTest, testing::Values(Kind::sqlite, Kind::postgres),
                         [](const auto& each) {
                           return each.param == Kind::sqlite ? "sqlite" : "postgres";
                         });

TEST_P(QueueTest, makes_each_change_of_the_table_and_no_other) {
  for (const JobState from : job_states) {
    for (const JobState to : job_states) {
      const JobId id = job_in(from);
      if (is_permitted(from, to)) {
        EXPECT_NO_THROW(go(id, to)) << name_of(from) << " -> " << name_of(to);
        EXPECT_EQ(jobs.find(id)->state, to);
        EXPECT_EQ(jobs.history(id).back().from, from);
        EXPECT_EQ(jobs.history(id).back().to, to);
      } else {
        const auto changes = jobs.history(id).size();
        EXPECT_THROW(go(id, to), NotPermitted) << name_of(from) << " -> " << name_of(to);
        EXPECT_EQ(jobs.find(id)->state, from);
        EXPECT_EQ(jobs.history(id).size(), changes);
      }
    }
  }
}

// From the requirement: what must not be, whatever way a job takes.
TEST(job_states, every_way_to_printing_goes_through_a_check_and_a_committed_start) {
  std::set<JobState> reached{JobState::uploaded};
  for (std::size_t size = 0; size != reached.size();) {
    size = reached.size();
    for (const Transition& row : transitions) {
      if (row.to == JobState::starting || row.from == JobState::checking) continue;
      if (reached.contains(row.from)) reached.insert(row.to);
    }
  }
  EXPECT_EQ(reached, (std::set{JobState::uploaded, JobState::checking, JobState::cancelled}));
}

TEST(job_states, each_has_a_name_that_leads_back_and_all_can_be_reached) {
  for (const JobState state : job_states) {
    EXPECT_EQ(state_named(name_of(state)), state);
    bool reached = state == JobState::uploaded;
    for (const Transition& row : transitions) reached |= row.to == state;
    EXPECT_TRUE(reached) << name_of(state);
  }
  EXPECT_EQ(state_named("printed"), std::nullopt);
}

TEST_P(QueueTest, is_the_same_after_it_was_opened_again) {
  const JobId first = checked("first");
  start(first);
  jobs.set_check(first, R"({"lines":3})", 12.5, 30.25, 3);
  checked("second");
  jobs.set_bed_clear("right", true);
  Queue again = open();
  ASSERT_EQ(again.jobs().size(), 2u);
  const Job job = *again.find(first);
  EXPECT_EQ(job.state, JobState::starting);
  EXPECT_EQ(job.printer, "left");
  EXPECT_EQ(job.check, R"({"lines":3})");
  EXPECT_EQ(job.seconds, 12.5);
  EXPECT_EQ(job.filament_mm, 30.25);
  EXPECT_EQ(job.commands, 3);
  EXPECT_EQ(job.starts, 1);
  EXPECT_TRUE(again.bed_is_clear("right"));
  EXPECT_FALSE(again.bed_is_clear("left"));
}

TEST_P(QueueTest, keeps_the_order_that_people_give_it) {
  const JobId a = checked("a"), b = checked("b"), c = checked("c");
  EXPECT_THAT(order(), ElementsAre("a", "b", "c"));
  jobs.move(c, a);
  EXPECT_THAT(order(), ElementsAre("c", "a", "b"));
  EXPECT_EQ(jobs.next_for("left")->id, c);
  jobs.move(c, b);
  EXPECT_THAT(order(), ElementsAre("a", "c", "b"));
  jobs.move(a, std::nullopt);
  EXPECT_THAT(order(), ElementsAre("c", "b", "a"));
  jobs.move(b, b);
  EXPECT_THAT(order(), ElementsAre("c", "b", "a"));
  start(c);
  EXPECT_THROW(jobs.move(c, a), NotPermitted);
  EXPECT_THROW(jobs.move(a, 999), NoSuchJob);
  EXPECT_THAT(open().jobs(), testing::SizeIs(3));
}

TEST_P(QueueTest, starts_only_where_a_person_has_confirmed_the_free_bed) {
  const JobId first = checked("first"), second = checked("second");
  EXPECT_THROW(jobs.start(first, "left"), NotPermitted);
  jobs.set_bed_clear("right", true);
  EXPECT_THROW(jobs.start(first, "left"), NotPermitted) << "another printer's bed";
  start(first);
  jobs.change(first, JobState::printing, "");
  jobs.change(first, JobState::finished, "");
  EXPECT_THROW(jobs.start(second, "left"), NotPermitted) << "the first one lies there";
  EXPECT_EQ(jobs.find(second)->state, JobState::queued);
}

TEST_P(QueueTest, gives_a_printer_one_job_at_a_time) {
  const JobId first = checked("first"), second = checked("second");
  start(first);
  jobs.set_bed_clear("left", true);
  EXPECT_THROW(jobs.start(second, "left"), NotPermitted);
  EXPECT_EQ(jobs.active_on("left")->id, first);
  EXPECT_NO_THROW(start(second, "right"));
}

TEST_P(QueueTest, takes_a_start_back_with_the_bed_as_it_was) {
  const JobId id = checked("job");
  start(id);
  jobs.take_back(id, "the feeder has not begun");
  EXPECT_EQ(jobs.find(id)->state, JobState::queued);
  EXPECT_EQ(jobs.find(id)->starts, 0);
  EXPECT_TRUE(jobs.bed_is_clear("left"));
  EXPECT_THROW(jobs.take_back(id, ""), NotPermitted);
}

TEST_P(QueueTest, a_bed_that_is_not_clear_any_more_stays_so_when_a_start_is_taken_back) {
  const JobId id = checked("job");
  start(id);
  EXPECT_TRUE(jobs.bed_is_taken("left"));
  jobs.set_bed_clear("left", false);
  EXPECT_FALSE(jobs.bed_is_taken("left"));
  jobs.take_back(id, "the feeder has not begun");
  EXPECT_FALSE(jobs.bed_is_clear("left"));
  EXPECT_THROW(jobs.start(id, "left"), NotPermitted);
}

TEST_P(QueueTest, starts_no_held_job_and_none_that_is_for_another_printer) {
  const JobId held = add({.name = "h", .file = {}, .bytes = 1, .held = true});
  const JobId other =
      add({.name = "o", .file = {}, .bytes = 1, .held = false, .wanted_printer = "right"});
  for (const JobId id : {held, other}) {
    jobs.change(id, JobState::checking, "");
    jobs.change(id, JobState::queued, "");
    EXPECT_THROW(start(id), NotPermitted);
  }
  EXPECT_FALSE(jobs.next_for("left"));
  EXPECT_EQ(jobs.next_for("right")->id, other);
  jobs.set_held(held, false);
  EXPECT_EQ(jobs.next_for("left")->id, held);
}

TEST_P(QueueTest, prints_again_as_a_new_job_and_forgets_only_what_is_over) {
  const JobId id = checked("job");
  EXPECT_THROW(jobs.remove(id), NotPermitted);
  EXPECT_THROW(jobs.print_again(id), NotPermitted);
  jobs.change(id, JobState::cancelled, "");
  const JobId again = jobs.print_again(id);
  EXPECT_GT(again, id);
  EXPECT_EQ(jobs.find(again)->state, JobState::uploaded) << "it is checked again";
  jobs.remove(id);
  EXPECT_FALSE(jobs.find(id));
  EXPECT_THAT(jobs.files_in_use(), ElementsAre("job.gcode")) << "of the new one";
  const JobId refused = job_in(JobState::refused);
  EXPECT_THROW(jobs.print_again(refused), NotPermitted);
}

TEST_P(QueueTest, never_uses_a_number_twice) {
  const JobId id = checked("job");
  jobs.change(id, JobState::cancelled, "");
  jobs.remove(id);
  EXPECT_GT(checked("next"), id);
}

TEST_P(QueueTest, starts_a_job_only_while_it_is_the_next_one_of_its_printer) {
  const JobId first = checked("first"), second = checked("second");
  jobs.set_bed_clear("left", true);
  EXPECT_FALSE(jobs.start_if_next(second, "left"));
  jobs.move(second, first);
  EXPECT_FALSE(jobs.start_if_next(first, "left"));
  EXPECT_TRUE(jobs.start_if_next(second, "left"));
  EXPECT_EQ(jobs.find(second)->state, JobState::starting);
  EXPECT_EQ(jobs.find(first)->state, JobState::queued);
}

TEST_P(QueueTest, keeps_texts_of_any_kind_readable) {
  const JobId id = checked("job");
  const std::string name = "it's 100 % \"näher\"? \\ ; $1 \xf0\x9f\x96\xa8";
  jobs.rename(id, name);
  EXPECT_EQ(jobs.find(id)->name, name);
  jobs.change(id, JobState::cancelled, "a broken byte \xff of a file");
  EXPECT_THAT(jobs.find(id)->reason, testing::StartsWith("a broken byte "));
  EXPECT_THAT(jobs.find(id)->reason, testing::EndsWith(" of a file"));
}

TEST_P(QueueTest, says_which_job_is_missing) {
  EXPECT_THROW(jobs.change(5, JobState::checking, ""), NoSuchJob);
  EXPECT_THROW(jobs.remove(5), NoSuchJob);
  EXPECT_FALSE(jobs.find(5));
}

}  // namespace
