// SPDX-License-Identifier: Apache-2.0
// From upload to print, with real feeders and checks: free beds, order, refusals.
#include "host/spooler/spooler.hpp"

#include <gmock/gmock.h>

#include "directories.hpp"
#include "host/spooler/checker.hpp"
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
  expect_printed(id);
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

TEST_F(SpoolerTest, pauses_resumes_and_cancels) {
  const auto id = begin_print(2000, 50);
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
  const auto id = begin_print(2000, 50);
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
