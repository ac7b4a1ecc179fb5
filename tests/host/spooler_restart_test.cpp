// SPDX-License-Identifier: Apache-2.0
// Spoolers, feeders and printers that end in the middle of a print, and jobs that end badly.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>

#include "host/spooler/spooler.hpp"
#include "tests/host/spooler_fixture.hpp"

namespace {

using host_test::SpoolerTest;
using queue::JobState;
using testing::HasSubstr;

TEST_F(SpoolerTest, a_print_goes_on_without_spooler_and_the_next_one_attaches) {
  const auto id = begin_print(1500, 50);
  end_spooler();
  const auto before = left.executed().size();
  ASSERT_LT(before, wanted.size());
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_GT(left.executed().size(), before) << "it stands still";
  begin_spooler();
  expect_printed(id);
}

TEST_F(SpoolerTest, a_print_that_ends_without_spooler_is_known_to_the_next_one) {
  const auto id = begin_print(300, 50);
  end_spooler();
  while (left.executed().size() < wanted.size()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  begin_spooler();
  expect_printed(id);
  EXPECT_EQ(spool().find(id)->starts, 1);
}

TEST_F(SpoolerTest, a_feeder_that_was_killed_comes_again_and_goes_on) {
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  for (std::size_t lines = 100; lines < 700; lines += 200) {
    expect_executed(lines);
    kill_feeder();
  }
  expect_printed(id);
}

// What was committed as starting when the spooler ended, and of which the feeder knows nothing.
TEST_F(SpoolerTest, a_job_whose_start_never_left_is_started_by_the_next_spooler) {
  const auto id = upload_moves(30);
  expect_state(id, JobState::queued);
  restart_with(id, JobState::starting);
  expect_printed(id);
  EXPECT_EQ(spool().find(id)->starts, 1);
}

TEST_F(SpoolerTest, does_not_begin_when_the_bed_is_not_clear_any_more) {
  const auto id = upload_moves(30);
  expect_state(id, JobState::queued);
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  signal_feeder(SIGSTOP);
  spool().set_bed_clear("left", true);
  expect_state(id, JobState::starting);
  EXPECT_THROW(spool().set_bed_clear("left", false), spooler::Refused);
  kill_feeder();  // what it was sent is lost with it
  expect_state(id, JobState::queued);
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(spool().find(id)->state, JobState::queued);
  EXPECT_FALSE(printer_state().at("bed_clear"));
  EXPECT_EQ(left.executed().size(), 0u);
  spool().set_bed_clear("left", true);
  expect_state(id, JobState::finished);
}

TEST_F(SpoolerTest, a_job_that_the_feeder_has_forgotten_is_interrupted_and_a_person_decides) {
  const auto id = upload_moves(30);
  expect_state(id, JobState::queued);
  restart_with(id, JobState::printing);
  expect_state(id, JobState::interrupted);
  spool().set_bed_clear("left", true);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(left.executed().size(), 0u) << "printed again without being asked";
  EXPECT_EQ(spool().print_again(id), id);
  expect_printed(id);
  EXPECT_EQ(spool().find(id)->starts, 2);
}

TEST_F(SpoolerTest, a_restarted_printer_interrupts_its_job_and_the_bed_is_not_clear) {
  const auto id = begin_print(800, 100);
  left.with([](host_test::LinkPrinter& printer) { printer.restart(); });
  expect_state(id, JobState::interrupted);
  EXPECT_FALSE(printer_state().at("bed_clear"));
  spool().cancel(id);
  EXPECT_EQ(spool().find(id)->state, JobState::cancelled);
}

TEST_F(SpoolerTest, a_job_that_ended_badly_leaves_no_heater_on_and_its_cancel_sees_to_that) {
  const auto heaters_off = [&] { return std::ranges::count(left.executed(), "M104 S0"); };
  const auto id = begin_print(800, 100);
  left.with([](host_test::LinkPrinter& printer) { printer.say("Error:something odd"); });
  expect_state(id, JobState::failed);
  EXPECT_EQ(heaters_off(), 1);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("something odd"));
  expect_soon([&] { return printer_state().at("feeder_job").is_null(); }, "not forgotten");
  spool().cancel(id);
  expect_soon([&] { return heaters_off() == 2; }, "heaters");
  EXPECT_EQ(spool().find(id)->state, JobState::failed);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("something odd"));
}

TEST_F(SpoolerTest, an_interrupted_job_can_be_given_up_although_its_printer_is_away) {
  const auto id = begin_print(800, 100);
  left.with([](host_test::LinkPrinter& printer) { printer.restart(); });
  expect_state(id, JobState::interrupted);
  left.unplug();
  expect_soon([&] { return printer_state().at("link") == "closed"; }, "link");
  EXPECT_THAT(printer_state().at("fault"), HasSubstr((folder_.path() / "left").string()));
  spool().cancel(id);
  EXPECT_EQ(spool().find(id)->state, JobState::cancelled);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("heaters"));
}

TEST_F(SpoolerTest, a_damaged_journal_interrupts_the_job_with_its_reason_and_the_heaters_off) {
  const auto id = begin_print(800, 100);
  end_spooler();
  kill_feeder();
  folder_.write("data/printers/left/journal.json", "{");
  begin_spooler();
  expect_state(id, JobState::interrupted);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("journal"));
  EXPECT_THAT(printer_state().at("fault"), HasSubstr("journal.json.damaged"));
  EXPECT_THAT(left.executed(), testing::Contains("M104 S0"));
}

}  // namespace
