// SPDX-License-Identifier: Apache-2.0
// Disks and feeders that fail: the others go on, and no file is lost.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <map>
#include <set>

#include "directories.hpp"
#include "host/feeder/feeder_names.hpp"
#include "host/queue/sqlite_database.hpp"
#include "host/spooler/feeder_link.hpp"
#include "host/spooler/spooler.hpp"
#include "tests/host/spooler_fixture.hpp"
#include "tools/files/file_text.hpp"

namespace {

using host_test::SpoolerTest;
using queue::JobState;
using testing::HasSubstr;

// As with a full disk: printing goes on, the fault is shown, and all is made up for.
TEST_F(SpoolerTest, goes_on_when_the_queue_can_be_written_again) {
  const auto id = begin_print(800, 50);
  expect_state(id, JobState::printing);
  {
    queue::SqliteDatabase other(data() / "queue.db");
    queue::Transaction lock(other);  // the spooler's writes fail after some seconds
    expect_soon([&] { return left.executed().size() >= wanted.size(); }, "it stands still");
    std::this_thread::sleep_for(std::chrono::seconds(7));
    EXPECT_NE(spool().snapshot()->json.at("fault"), "");
  }
  expect_state(id, JobState::finished);
  expect_soon([&] { return spool().snapshot()->json.at("fault") == ""; }, "fault");
}

// The feeder may read the commands of the first one again at any time.
TEST_F(SpoolerTest, a_job_printed_again_has_commands_of_its_own) {
  const auto id = upload("G28 X\n", "a.gcode", true);
  expect_state(id, JobState::queued);
  spool().cancel(id);
  const auto commands = [this] {
    std::map<std::filesystem::path, ino_t> found;
    for (const auto& entry : std::filesystem::directory_iterator(data() / "files")) {
      struct stat status{};
      if (entry.path().extension() != ".commands") continue;
      EXPECT_EQ(stat(entry.path().c_str(), &status), 0);
      EXPECT_EQ(status.st_mode & 0777u, 0600u) << "for this user alone";
      found[entry.path()] = status.st_ino;
    }
    return found;
  };
  const auto first = commands();
  ASSERT_EQ(first.size(), 1u);
  const auto again = spool().print_again(id);
  expect_state(again, JobState::queued);
  EXPECT_EQ(commands().size(), 2u);
  EXPECT_EQ(commands().at(first.begin()->first), first.begin()->second);
  spool().remove(id);
  EXPECT_EQ(commands().size(), 1u);
  EXPECT_FALSE(commands().contains(first.begin()->first));
  spool().set_bed_clear("left", true);
  expect_state(again, JobState::finished);
}

TEST_F(SpoolerTest, removes_no_file_when_the_queue_was_lost) {
  const auto id = begin_print(800, 50);
  const auto files = [this] {
    std::set<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(data() / "files")) {
      found.insert(entry.path());
    }
    return found;
  };
  const auto before = files();
  ASSERT_EQ(before.size(), 2u);
  expect_state(id, JobState::printing);
  for (int start = 0; start < 2; ++start) {
    end_spooler();
    for (const char* name : {"queue.db", "queue.db-wal", "queue.db-shm"}) {
      if (start == 0) std::filesystem::remove(data() / name);
    }
    begin_spooler();
    EXPECT_EQ(files(), before);
  }
  EXPECT_THAT(spool().snapshot()->json.at("fault").get<std::string>(), HasSubstr("queue.db"));
  const auto next = upload("G28 Y\n", "b.gcode", true);
  expect_state(next, JobState::queued);
  end_spooler();
  begin_spooler();
  EXPECT_THAT(files(), testing::IsSupersetOf(before)) << "also once there are jobs again";
}

// As with a full disk: nothing can be written in the left printer's folder.
TEST_F(SpoolerTest, a_printer_whose_feeder_cannot_be_started_does_not_stop_the_other_one) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  const auto note = data() / "printers/left/feeder.process";
  kill_feeder();
  std::filesystem::remove(note);
  std::filesystem::create_directory(note);
  expect_soon([&] { return spool().snapshot()->json.at("fault") != ""; }, "no fault");
  const auto id = upload("G28 X\n", "r.gcode", false, "right");
  spool().set_bed_clear("right", true);
  expect_state(id, JobState::finished);
  std::filesystem::remove(note);
  expect_soon([&] { return std::filesystem::exists(note); }, "no note");
  expect_soon([&] { return spool().snapshot()->json.at("fault") == ""; }, "fault");
}

TEST_F(SpoolerTest, hears_all_of_a_feeder_although_one_answer_cannot_be_written_down) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "printers/x");
  feeder::Listener listener(folder.path() / "printers/x", feeder::socket_name);
  spooler::Settings settings;
  settings.data = folder.path();
  spooler::FeederLink link(settings, {.name = "x", .port = "/dev/null"});
  link.update();
  auto connections = listener.accept();
  ASSERT_EQ(connections.size(), 1u);
  std::vector<std::string> refusals;
  link.ask({{"do", "start"}}, [](const std::string&) { throw std::runtime_error("disk full"); });
  link.ask({{"do", "pause"}}, [&](const std::string& refusal) { refusals.push_back(refusal); });
  connections.front().send(R"({"event":"answer","refused":"no"})"
                           "\n"
                           R"({"event":"answer","refused":"not now"})");
  connections.front().exchange();
  EXPECT_THROW(link.update(), std::runtime_error);
  EXPECT_EQ(refusals, std::vector<std::string>{"not now"});
  EXPECT_FALSE(link.is_asked());
}

class CheckFaultTest : public SpoolerTest {
 protected:
  // By this script: $1 is `plan`, $2 the file, $4 the plan, $6 the commands, $real the program.
  void check_with(const std::string& script, std::chrono::milliseconds interval) {
    folder_.write("plan.sh", "#!/bin/sh\nreal=" BUILD_DIRECTORY "/bin/stepfabric\ncd " + here() +
                                 "\n" + script);
    std::filesystem::permissions(folder_.path() / "plan.sh", std::filesystem::perms::owner_all);
    end_spooler();
    check_program = folder_.path() / "plan.sh";
    check_interval = interval;
    begin_spooler();
  }
  std::string here() const { return folder_.path().string(); }
  std::string fault() { return spool().snapshot()->json.at("fault"); }
};

// As on a disk that is full for all files with this word.
const std::string full_for_some =
    "if grep -q FULL \"$2\"; then\n  echo attempt >> attempts\n  echo No space left on device\n"
    "  exit 2\nfi\nexec $real \"$@\"\n";

// The program's first call finds the disk full, as /dev/full is; the next one does not.
TEST_F(CheckFaultTest, a_check_that_finds_the_disk_full_is_done_again) {
  check_with(
      "if [ ! -e first ]; then\n  touch first\n"
      "  exec $real plan \"$2\" --json \"$4\" --commands /dev/full\nfi\nexec $real \"$@\"\n",
      std::chrono::seconds(1));
  const auto id = upload("G28 X\n", "a.gcode", true);
  expect_soon([&] { return fault() != ""; }, "no fault");
  EXPECT_THAT(fault(), testing::AllOf(HasSubstr("a.gcode"), HasSubstr("No space left on device")));
  expect_state(id, JobState::queued);
  EXPECT_EQ(fault(), "");
}

TEST_F(CheckFaultTest, a_check_that_cannot_be_done_holds_up_no_other_job) {
  check_with(full_for_some, std::chrono::hours(1));
  const auto first = upload("G28 X ; FULL\n", "a.gcode", true);
  expect_soon([&] { return fault() != ""; }, "no fault");
  expect_state(upload("G28 X\n", "b.gcode", true), JobState::queued);
  EXPECT_EQ(spool().find(first)->state, JobState::uploaded);
  EXPECT_THAT(fault(), HasSubstr("a.gcode")) << "of the job that still waits";
  spool().cancel(first);
  expect_soon([&] { return fault() == ""; }, "the fault of a job that is cancelled");
}

TEST_F(CheckFaultTest, a_job_is_refused_after_ten_checks_that_could_not_be_done) {
  check_with(full_for_some, std::chrono::milliseconds(10));
  const auto id = upload("G28 X ; FULL\n", "a.gcode", true);
  expect_state(id, JobState::refused);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("No space left on device"));
  EXPECT_EQ(files::text_of(folder_.path() / "attempts").size(),
            10 * std::string("attempt\n").size());
  EXPECT_EQ(fault(), "");
}

// As by a program of another version: it would be the same at each attempt.
TEST_F(CheckFaultTest, a_job_whose_plan_cannot_be_understood_is_refused) {
  check_with("echo '{}' > \"$4\"\n: > \"$6\"\n", std::chrono::hours(1));
  const auto id = upload("G28 X\n", "a.gcode", true);
  expect_state(id, JobState::refused);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("the check failed: "));
}

TEST_F(CheckFaultTest, the_file_of_a_removed_job_goes_although_another_one_is_checked) {
  check_with(
      "if grep -q LONG \"$2\"; then\n  while [ ! -e end ]; do sleep 0.1; done\nfi\n"
      "exec $real \"$@\"\n",
      std::chrono::hours(1));
  const auto removed = upload("G28 X\n", "a.gcode", true);
  expect_state(removed, JobState::queued);
  const std::filesystem::path file = spool().store().path_of(spool().find(removed)->file);
  const auto checked = upload("G28 X ; LONG\n", "b.gcode", true);
  expect_state(checked, JobState::checking);
  spool().cancel(removed);
  spool().remove(removed);
  EXPECT_FALSE(std::filesystem::exists(file));
  folder_.write("end", "");
  expect_state(checked, JobState::queued);
}

TEST_F(CheckFaultTest, a_file_of_nonsense_makes_no_long_report) {
  check_with("$real \"$@\" > said\nstatus=$?\ncp \"$4\" written\nexit $status\n",
             std::chrono::hours(1));
  std::string nonsense;
  for (int i = 0; i < 5'000; ++i) nonsense += "M9999 X" + std::to_string(i) + "\n";
  const auto id = upload(nonsense, "a.gcode", true);
  expect_state(id, JobState::refused);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("4999 more"));
  const auto check = nlohmann::json::parse(spool().find(id)->check);
  EXPECT_EQ(check.at("refused_lines"), 5'000);
  EXPECT_EQ(check.at("refused").size(), 200u);
  EXPECT_LT(std::filesystem::file_size(folder_.path() / "written"), 100'000u);
  EXPECT_LT(std::filesystem::file_size(folder_.path() / "said"), 100'000u);
}

}  // namespace
