// SPDX-License-Identifier: Apache-2.0
// From upload to print, with real feeders and checks: free beds, restarts, refusals, decisions.
#include "host/spooler/spooler.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>

#include <map>
#include <set>

#include <algorithm>

#include "directories.hpp"
#include "host/feeder/feeder_names.hpp"
#include "host/spooler/checker.hpp"
#include "host/spooler/feeder_link.hpp"
#include "tests/host/spooler_fixture.hpp"
#include "tools/files/file_text.hpp"

namespace {

using host_test::SpoolerTest;
using nlohmann::json;
using queue::JobState;
using testing::HasSubstr;

TEST_F(SpoolerTest, prints_what_was_uploaded_once_the_bed_is_clear) {
  const auto id = upload_moves(100);
  expect_state(id, JobState::queued);
  EXPECT_GT(spool().find(id)->seconds, 0);
  EXPECT_EQ(spool().find(id)->commands, 100);
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(spool().find(id)->state, JobState::queued) << "without a free bed";
  spool().set_bed_clear("left", true);
  expect_state(id, JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
  EXPECT_EQ(right.executed().size(), 0u);
  EXPECT_FALSE(printer_state().at("bed_clear"));
}

TEST_F(SpoolerTest, the_next_job_waits_for_the_bed_and_the_order_is_that_of_the_queue) {
  const auto first = upload_moves(20), second = upload("G28 X\n"), third = upload("G28 Y\n");
  for (const auto id : {first, second, third}) expect_state(id, JobState::queued);
  spool().move(third, second);
  spool().set_bed_clear("left", true);
  expect_state(first, JobState::finished);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(spool().find(third)->state, JobState::queued);
  spool().set_bed_clear("left", true);
  expect_state(third, JobState::finished);
  EXPECT_EQ(spool().find(second)->state, JobState::queued);
}

TEST_F(SpoolerTest, never_prints_a_file_with_a_refused_line) {
  spool().set_bed_clear("left", true);
  const auto id = upload("G28 X\nG1 X5000 F600\nM9999\n");
  expect_state(id, JobState::refused);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("line 2: G1 X5000"));
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("1 more"));
  const json check = json::parse(spool().find(id)->check);
  EXPECT_EQ(check.at("refused").at(1).at("line"), 3);
  const auto binary = upload(std::string("G28\n\0\x01", 6));
  expect_state(binary, JobState::refused);
  EXPECT_NE(spool().find(binary)->reason, "");
  EXPECT_THROW(spool().print_again(id), queue::NotPermitted);
  EXPECT_EQ(left.executed().size(), 0u);
  EXPECT_TRUE(printer_state().at("bed_clear"));
}

TEST_F(SpoolerTest, a_print_goes_on_without_spooler_and_the_next_one_attaches) {
  const auto id = upload_moves(1500);
  spool().set_bed_clear("left", true);
  expect_executed(50);
  end_spooler();
  const auto before = left.executed().size();
  ASSERT_LT(before, wanted.size());
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_GT(left.executed().size(), before) << "it stands still";
  begin_spooler();
  expect_state(id, JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
}

TEST_F(SpoolerTest, a_print_that_ends_without_spooler_is_known_to_the_next_one) {
  const auto id = upload_moves(300);
  spool().set_bed_clear("left", true);
  expect_executed(50);
  end_spooler();
  while (left.executed().size() < wanted.size()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  begin_spooler();
  expect_state(id, JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
  EXPECT_EQ(spool().find(id)->starts, 1);
}

TEST_F(SpoolerTest, a_feeder_that_was_killed_comes_again_and_goes_on) {
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  for (std::size_t lines = 100; lines < 700; lines += 200) {
    expect_executed(lines);
    kill_feeder();
  }
  expect_state(id, JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
}

// What was committed as starting when the spooler ended, and of which the feeder knows nothing.
TEST_F(SpoolerTest, a_job_whose_start_never_left_is_started_by_the_next_spooler) {
  const auto id = upload_moves(30);
  expect_state(id, JobState::queued);
  end_spooler();
  {
    queue::Queue jobs(data() / "queue.db");
    jobs.set_bed_clear("left", true);
    jobs.start(id, "left");
  }
  begin_spooler();
  expect_state(id, JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
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
  end_spooler();
  {
    queue::Queue jobs(data() / "queue.db");
    jobs.set_bed_clear("left", true);
    jobs.start(id, "left");
    jobs.change(id, JobState::printing, "");
  }
  begin_spooler();
  expect_state(id, JobState::interrupted);
  spool().set_bed_clear("left", true);
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(left.executed().size(), 0u) << "printed again without being asked";
  EXPECT_EQ(spool().print_again(id), id);
  expect_state(id, JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
  EXPECT_EQ(spool().find(id)->starts, 2);
}

TEST_F(SpoolerTest, a_restarted_printer_interrupts_its_job_and_the_bed_is_not_clear) {
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  expect_executed(100);
  left.with([](host_test::LinkPrinter& printer) { printer.restart(); });
  expect_state(id, JobState::interrupted);
  EXPECT_FALSE(printer_state().at("bed_clear"));
  spool().cancel(id);
  EXPECT_EQ(spool().find(id)->state, JobState::cancelled);
}

TEST_F(SpoolerTest, a_job_that_ended_badly_leaves_no_heater_on_and_its_cancel_sees_to_that) {
  const auto heaters_off = [&] { return std::ranges::count(left.executed(), "M104 S0"); };
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  expect_executed(100);
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
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  expect_executed(100);
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
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  expect_executed(100);
  end_spooler();
  kill_feeder();
  folder_.write("data/printers/left/journal.json", "{");
  begin_spooler();
  expect_state(id, JobState::interrupted);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("journal"));
  EXPECT_THAT(printer_state().at("fault"), HasSubstr("journal.json.damaged"));
  EXPECT_THAT(left.executed(), testing::Contains("M104 S0"));
}

TEST_F(SpoolerTest, pauses_resumes_and_cancels) {
  const auto id = upload_moves(2000);
  spool().set_bed_clear("left", true);
  expect_executed(50);
  EXPECT_THROW(spool().set_bed_clear("left", true), spooler::Refused);
  EXPECT_THROW(spool().ask("left", {{"do", "resume"}}), spooler::Refused);
  spool().ask("left", {{"do", "pause"}});
  expect_state(id, JobState::paused);
  spool().ask("left", {{"do", "resume"}});
  expect_state(id, JobState::printing);
  spool().cancel(id);
  expect_state(id, JobState::cancelled);
  EXPECT_EQ(left.executed().back(), "M84");
  EXPECT_THROW(spool().cancel(id), queue::NotPermitted);
  EXPECT_THROW(spool().ask("middle", {{"do", "pause"}}), spooler::NoSuchPrinter);
}

TEST_F(SpoolerTest, an_emergency_stop_fails_the_job) {
  const auto id = upload_moves(2000);
  spool().set_bed_clear("left", true);
  expect_executed(50);
  spool().ask("left", {{"do", "stop"}});
  expect_state(id, JobState::failed);
  EXPECT_THAT(spool().find(id)->reason, HasSubstr("emergency stop"));
  EXPECT_LT(left.executed().size(), wanted.size());
}

TEST_F(SpoolerTest, two_printers_print_two_jobs_and_each_only_its_own) {
  const auto any = upload("G28 X\n");
  const auto for_right = upload("G28 Y\n", "r.gcode", false, "right");
  for (const auto id : {any, for_right}) expect_state(id, JobState::queued);
  spool().set_bed_clear("left", true);
  expect_state(any, JobState::finished);
  spool().set_bed_clear("left", true);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(spool().find(for_right)->state, JobState::queued);
  spool().set_bed_clear("right", true);
  expect_state(for_right, JobState::finished);
  EXPECT_EQ(right.executed(), std::vector<std::string>{"G28 Y"});
}

TEST_F(SpoolerTest, a_held_job_waits_for_its_release_and_a_removed_one_takes_its_files_with_it) {
  const auto id = upload_moves(10, true);
  spool().set_bed_clear("left", true);
  expect_state(id, JobState::queued);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(spool().find(id)->state, JobState::queued);
  spool().set_held(id, false);
  expect_state(id, JobState::finished);
  const auto again = spool().print_again(id);
  spool().remove(id);
  expect_state(again, JobState::queued);
  spool().cancel(again);
  EXPECT_FALSE(std::filesystem::is_empty(data() / "files"));
  spool().remove(again);
  EXPECT_TRUE(std::filesystem::is_empty(data() / "files"));
}

// As with a full disk: printing goes on, the fault is shown, and all is made up for.
TEST_F(SpoolerTest, goes_on_when_the_queue_can_be_written_again) {
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  expect_executed(50);
  expect_state(id, JobState::printing);
  {
    queue::Database other(data() / "queue.db");
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
  const auto id = upload_moves(800);
  spool().set_bed_clear("left", true);
  expect_executed(50);
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

TEST_F(SpoolerTest, a_second_one_on_the_same_folder_is_refused) {
  spooler::Settings same;
  same.data = data();
  EXPECT_THROW(spooler::Spooler{same}, std::runtime_error);
}

TEST(check, gives_what_is_sent_without_comments_and_line_numbers_of_its_own) {
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
  const TemporaryFolder folder;
  const auto commands = folder.path() / "job.commands";
  folder.write("job.gcode", "; first\nG28 X ; home\n\nM110 N5\nM117 Hello\n");
  const auto good =
      spooler::check(BUILD_DIRECTORY "/bin/stepfabric", folder.path() / "job.gcode", commands);
  EXPECT_TRUE(good.accepted) << good.reason;
  EXPECT_EQ(good.commands, 2);
  EXPECT_EQ(files::text_of(commands), "G28 X\nM117 Hello\n");
  folder.write("job.gcode", "M117 " + std::string(108, 'x') + "\n");
  const auto long_one =
      spooler::check(BUILD_DIRECTORY "/bin/stepfabric", folder.path() / "job.gcode", commands);
  EXPECT_FALSE(long_one.accepted);
  EXPECT_EQ(files::text_of(commands), "G28 X\nM117 Hello\n") << "of the accepted one";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2)
      << "nothing is left behind";
  EXPECT_THAT(long_one.reason, HasSubstr("too long"));
}

TEST(printers_of, reads_ports_and_simulated_ones) {
  using spooler::PrinterSpec;
  EXPECT_EQ(spooler::printers_of({"left=/dev/ttyUSB0", "simulated"}),
            (std::vector<PrinterSpec>{{.name = "left", .port = "/dev/ttyUSB0"},
                                      {.name = "simulated", .port = {}}}));
  EXPECT_EQ(spooler::printers_of({"simulated:3"}).size(), 3u);
  EXPECT_EQ(spooler::printers_of({"simulated:2"})[1].name, "simulated-2");
  for (const char* wrong : {"left", "=x", "left=", "a/b=x", "..=x", "simulated:0", "simulated:17",
                            "simulated:x", "simulated:1x"}) {
    EXPECT_THROW(spooler::printers_of({wrong}), std::runtime_error) << wrong;
  }
  EXPECT_THROW(spooler::printers_of({"a=x", "a=y"}), std::runtime_error);
  EXPECT_THROW(spooler::printers_of({"a=x", "b=x"}), std::runtime_error);
}

}  // namespace
