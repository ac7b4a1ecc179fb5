// SPDX-License-Identifier: Apache-2.0
// Whole prints on the co-simulated chip, uploaded by curl as PrusaSlicer does, with both processes
// killed on the way, to the step.
#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/host/spooled_print.hpp"

namespace {

namespace fs = std::filesystem;
using namespace host_test;
using testing::HasSubstr;

TEST_F(SpooledPrint, makes_the_edges_of_print_though_feeder_and_spooler_are_killed) {
  const std::string text = job(400);
  begin_chip();
  begin_spooler("chip=" + (folder / "port").string());
  EXPECT_EQ(upload(text), "201");
  clear_bed("chip");
  for (const std::int64_t line : {80, 160}) {
    expect_soon([&] { return done() >= line; }, "no progress");
    ASSERT_EQ(job_state(), "printing");
    kill_feeder("chip");
    expect_soon([&] { return done() > line + 40; }, "it does not go on after the kill");
  }
  ASSERT_LT(done(), 360) << "printed before the spooler was killed";
  kill_spooler();
  const auto edges = fs::file_size(folder / "edges");
  expect_soon([&] { return fs::file_size(folder / "edges") > edges; }, "no edge without spooler");
  begin_spooler("chip=" + (folder / "port").string());
  expect_soon([&] { return job_state() == "finished"; }, "not finished");
  expect_edges_of_print(text);
  EXPECT_EQ(state().at("jobs").at(0).at("starts"), 1);
}

TEST_F(SpooledPrint, prints_on_a_simulated_printer_that_it_starts_itself) {
  begin_spooler("simulated");
  EXPECT_EQ(upload("G28 X\nG1 X20 F6000\nG1 X5\n"), "201");
  clear_bed("simulated");
  expect_soon([&] { return job_state() == "finished"; }, "not finished");
  spooler->signal(SIGINT);
  EXPECT_EQ(spooler->wait().exit_status, 0);
  // Nothing is left running where nothing is printed.
  expect_soon(
      [&] {
        return !process::is_running(noted("simulated", "feeder.process")) &&
               !process::is_running(noted("simulated", "chip.process"));
      },
      "feeder or chip go on");
}

// What a spooler says that cannot start.
process::Captured refused(const fs::path& data, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {stepfabric, "spool", "--data", data.string()});
  return process::capture({.arguments = arguments, .has_input = false});
}

TEST_F(SpooledPrint, refuses_to_start_where_it_may_not) {
  const auto open = refused(folder / "data", {"--listen", "0.0.0.0:0", "--allow-root"});
  EXPECT_EQ(open.exit_status, 2);
  EXPECT_THAT(open.output, HasSubstr("--key"));
  EXPECT_EQ(refused(folder / "data", {"--printer", "left"}).exit_status, 2);
  EXPECT_EQ(refused(folder / "data", {"--listen", "here:there"}).exit_status, 2);
}

TEST_F(SpooledPrint, does_not_serve_others_as_root_and_names_the_remedy) {
  if (geteuid() != 0) GTEST_SKIP() << "this user is not root";
  const auto as_root = refused(folder / "data", {"--listen", "0.0.0.0:0"});
  EXPECT_EQ(as_root.exit_status, 2);
  EXPECT_THAT(as_root.output,
              testing::AllOf(HasSubstr("sudo -u"), HasSubstr("User="), HasSubstr("--allow-root")));
}

}  // namespace
