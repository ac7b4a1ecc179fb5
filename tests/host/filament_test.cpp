// SPDX-License-Identifier: Apache-2.0
// A job starts only where enough filament is left, as far as a person has said how much; and a bed
// does not stay clear because a person has said so once.
#include <gmock/gmock.h>

#include <thread>

#include "host/queue/sqlite_database.hpp"
#include "tests/host/spooler_fixture.hpp"

namespace {

using namespace std::chrono_literals;
using queue::JobState;

// So many lines with 1 mm of filament each.
std::string extruding(int lines) {
  std::string text = "M302 P1\nG92 X0 Y0 Z0 E0\nM83\n";
  for (int i = 0; i < lines; ++i) text += "G1 X" + std::to_string(i % 50) + " E1 F6000\n";
  return text;
}

class FilamentTest : public host_test::SpoolerTest {
 protected:
  // A long job on the left printer, of which 500 lines are executed.
  queue::JobId begin_long_job() {
    const auto id = upload(extruding(20'000));
    expect_state(id, JobState::queued);
    spool().set_bed_clear("left", true);
    expect_executed(500);
    return id;
  }
  double left_on(const std::string& printer) { return printer_state(printer).at("filament_mm"); }
};

TEST_F(FilamentTest, a_job_waits_for_enough_and_what_it_uses_is_taken_off) {
  const auto id = upload(extruding(100));
  expect_state(id, JobState::queued);
  EXPECT_DOUBLE_EQ(spool().find(id)->filament_mm, 100);
  EXPECT_TRUE(printer_state().at("filament_mm").is_null());
  spool().set_filament_left("left", 99);
  spool().set_bed_clear("left", true);
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(spool().find(id)->state, JobState::queued);
  EXPECT_EQ(left_on("left"), 99);
  EXPECT_TRUE(printer_state().at("bed_clear")) << "it still waits for the job";
  spool().set_filament_left("left", 130);
  expect_state(id, JobState::finished);
  expect_soon([&] { return left_on("left") == 30; }, "not taken off");
  end_spooler();
  begin_spooler();
  EXPECT_EQ(left_on("left"), 30) << "it is on the disk";
}

TEST_F(FilamentTest, nothing_waits_where_it_is_not_known_how_much_is_left) {
  const auto id = upload(extruding(100));
  spool().set_filament_left("left", 1);
  spool().set_filament_left("left", std::nullopt);
  spool().set_bed_clear("left", true);
  expect_state(id, JobState::finished);
  EXPECT_TRUE(printer_state().at("filament_mm").is_null());
}

TEST_F(FilamentTest, a_job_for_any_printer_goes_where_enough_is_left) {
  const auto id = upload(extruding(100));
  expect_state(id, JobState::queued);
  spool().set_filament_left("left", 50);
  spool().set_filament_left("right", 500);
  spool().set_bed_clear("left", true);
  spool().set_bed_clear("right", true);
  expect_state(id, JobState::finished);
  EXPECT_EQ(spool().find(id)->printer, "right");
  expect_soon([&] { return left_on("right") == 400; }, "not taken off");
  EXPECT_EQ(left_on("left"), 50);
}

TEST_F(FilamentTest, a_cancelled_job_has_used_what_was_sent) {
  spool().set_filament_left("left", 30'000);
  const auto id = begin_long_job();
  spool().cancel(id);
  expect_state(id, JobState::cancelled);
  const auto executed = static_cast<double>(left.executed().size());
  expect_soon([&] { return left_on("left") < 30'000; }, "nothing is taken off");
  EXPECT_NEAR(left_on("left"), 30'000 - executed, 10);
}

TEST_F(FilamentTest, what_is_said_in_the_middle_of_a_job_loses_only_the_rest) {
  const auto id = begin_long_job();
  spool().ask("left", {{"do", "pause"}});
  expect_state(id, JobState::paused);
  const auto before = left.executed().size();
  spool().set_filament_left("left", 30'000);
  spool().ask("left", {{"do", "resume"}});
  expect_executed(before + 300);
  spool().cancel(id);
  expect_state(id, JobState::cancelled);
  const auto since = static_cast<double>(left.executed().size() - before);
  expect_soon([&] { return left_on("left") < 30'000; }, "nothing is taken off");
  EXPECT_NEAR(left_on("left"), 30'000 - since, 20);
}

TEST_F(FilamentTest, a_killed_feeder_does_not_forget_what_was_used) {
  spool().set_filament_left("left", 30'000);
  const auto id = begin_long_job();
  expect_soon([&] { return printer_state().at("done") >= 400; }, "no progress is reported");
  signal_feeder(SIGSTOP);
  left.with([](host_test::LinkPrinter& printer) { printer.restart(); });
  kill_feeder();
  expect_state(id, JobState::interrupted);
  expect_soon([&] { return left_on("left") < 30'000; }, "nothing is taken off");
  EXPECT_LT(left_on("left"), 30'000 - 390);
}

class BedLimitTest : public host_test::SpoolerTest {
 protected:
  BedLimitTest() {
    end_spooler();
    bed_clear_limit = 1500ms;
    begin_spooler();
  }
};

TEST_F(BedLimitTest, a_bed_is_clear_for_a_limited_time) {
  spool().set_bed_clear("left", true);
  EXPECT_TRUE(printer_state().at("bed_clear"));
  expect_soon([&] { return !printer_state().at("bed_clear").get<bool>(); }, "it stays clear");
  const auto id = upload("G28 X\n");
  expect_state(id, JobState::queued);
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(spool().find(id)->state, JobState::queued);
  spool().set_bed_clear("left", true);
  expect_state(id, JobState::finished);
}

TEST_F(BedLimitTest, the_time_goes_on_while_no_spooler_runs) {
  spool().set_bed_clear("left", true);
  end_spooler();
  std::this_thread::sleep_for(1600ms);
  begin_spooler();
  const auto id = upload("G28 X\n");
  expect_state(id, JobState::queued);
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(spool().find(id)->state, JobState::queued);
}

// As the first versions have left it.
TEST(OldQueue, is_taken_over_and_its_beds_are_as_old_as_can_be) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "queue.db";
  {
    queue::SqliteDatabase database(file);
    database.execute(
        "CREATE TABLE beds(printer TEXT PRIMARY KEY, clear INTEGER NOT NULL);"
        "INSERT INTO beds VALUES('left', 1)");
  }
  queue::Queue jobs(file);
  EXPECT_TRUE(jobs.bed_is_clear("left"));
  EXPECT_EQ(jobs.clear_since("left"), 0);
  EXPECT_FALSE(jobs.filament_left("left"));
  jobs.set_filament_left("left", 5.5);
  EXPECT_EQ(queue::Queue(file).filament_left("left"), 5.5) << "opened again, it is taken as it is";
}

TEST(FilamentOfQueue, a_start_needs_it_in_the_same_transaction) {
  const TemporaryFolder folder;
  queue::Queue jobs(folder.path() / "queue.db");
  const auto id = jobs.add({.name = "a", .file = "a.gcode", .bytes = 1});
  jobs.change(id, JobState::checking, "");
  jobs.set_check(id, "{}", 1, 10, 1);
  jobs.change(id, JobState::queued, "");
  jobs.set_bed_clear("left", true);
  jobs.set_filament_left("left", 9.9);
  EXPECT_THROW(jobs.start(id, "left"), queue::NotPermitted);
  jobs.set_filament_left("left", 10);
  jobs.start(id, "left");
  jobs.change(id, JobState::printing, "");
  jobs.change(id, JobState::finished, "", 12);
  EXPECT_EQ(jobs.filament_left("left"), 0) << "not below 0";
}

}  // namespace
