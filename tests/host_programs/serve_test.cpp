// SPDX-License-Identifier: Apache-2.0
// `stepfabric serve` as seen by host programs: a port that may be opened, closed and opened again,
// and a job that ends cleanly on Ctrl-C.
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <fstream>
#include <regex>
#include <thread>

#include "directories.hpp"
#include "sim/devices/terminal_settings.hpp"
#include "tests/host_programs/serve_fixture.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
const std::string stepfabric = BUILD_DIRECTORY "/bin/stepfabric";
using host_programs::Serve;

TEST_F(Serve, hosts_come_and_go_and_ctrl_c_ends_it_with_the_report) {
  start({});
  int host = open_port();
  EXPECT_TRUE(connect(host));
  // Gone without reading what it has requested, in the middle of a line.
  write_text(host, "M115\nN1 G1 X5");
  close(host);
  std::this_thread::sleep_for(500ms);
  // A host at another baud rate is not understood, and has no effect.
  host = open_port();
  devices::set_raw(host, 115'200);
  write_text(host, "M105\nM105\n");
  std::this_thread::sleep_for(500ms);
  close(host);
  std::this_thread::sleep_for(500ms);
  host = open_port();
  write_text(host, "\nN0 M110 N0*125\n");
  read_until(host, "ok");
  write_text(host, "N1 M118 here*16\n");
  EXPECT_NE(read_until(host, "here\n").find("here\n"), std::string::npos);
  close(host);
  EXPECT_EQ(stop(), 0);
  EXPECT_FALSE(fs::exists(fs::symlink_status(port)));
  EXPECT_NE(file("report/report.json").find("\"result\": \"stopped\""), std::string::npos);
  EXPECT_NE(file("accepted").find("1\tM118 here\n"), std::string::npos);
}

// Which clock depends on the machine; the report must have the one that was announced.
TEST_F(Serve, in_real_time_the_chip_gets_a_clock_that_is_reported) {
  start({}, "real");
  const int host = open_port();
  EXPECT_TRUE(connect(host));
  close(host);
  EXPECT_EQ(stop(), 0);
  std::smatch announced, reported;
  const std::string output = file("output"), report = file("report/report.json");
  ASSERT_TRUE(std::regex_search(output, announced, std::regex("so the chip gets ([0-9.]+) MHz")))
      << output;
  ASSERT_TRUE(std::regex_search(report, reported, std::regex("\"clock_hz\": ([0-9]+)"))) << report;
  EXPECT_GE(std::stod(announced[1]), 2);
  EXPECT_DOUBLE_EQ(std::stod(announced[1]) * 1e6, std::stod(reported[1]));
}

TEST_F(Serve, opening_the_port_resets_the_chip_where_that_is_wanted) {
  start({"--reset-on-open"});
  for (int i = 0; i < 2; ++i) {
    const int host = open_port();
    EXPECT_NE(read_until(host, "start\n").find("start\n"), std::string::npos);
    write_text(host, "M118 again\n");
    EXPECT_NE(read_until(host, "again\n").find("again\n"), std::string::npos);
    close(host);
    std::this_thread::sleep_for(500ms);
  }
  EXPECT_EQ(stop(), 0);
  EXPECT_EQ(file("accepted"), "-\tM118 again\n-\tM118 again\n");
}

TEST_F(Serve, a_half_line_is_not_completed_by_the_next_host) {
  start({});
  int host = open_port();
  EXPECT_TRUE(connect(host));
  write_text(host, "G1 X7");
  std::this_thread::sleep_for(200ms);
  close(host);
  std::this_thread::sleep_for(50ms);
  host = open_port();
  write_text(host, "\n");
  write_text(host, "M118 here\n");
  EXPECT_NE(read_until(host, "here\n").find("here\n"), std::string::npos);
  close(host);
  EXPECT_EQ(stop(), 0);
  EXPECT_EQ(file("accepted").find("G1"), std::string::npos) << file("accepted");
}

TEST_F(Serve, the_first_bytes_after_a_reset_are_the_new_host_s_and_all_of_them) {
  start({"--reset-on-open"});
  for (int i = 0; i < 2; ++i) {
    const int host = open_port();
    write_text(host, "M118 first\nG1 X7");
    const std::string said = read_until(host, "first\n");
    EXPECT_NE(said.find("start\n"), std::string::npos) << said;
    EXPECT_NE(said.find("first\n"), std::string::npos) << said;
    close(host);
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_EQ(stop(), 0);
  EXPECT_EQ(file("accepted"), "-\tM118 first\n-\tM118 first\n");
}

// As `echo M118 here > port`.
TEST_F(Serve, a_host_that_only_writes_and_closes_is_obeyed) {
  start({});
  int host = open_port();
  EXPECT_TRUE(connect(host));
  close(host);
  host = open_port();
  write_text(host, "M118 here\n");
  close(host);
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(stop(), 0);
  EXPECT_NE(file("accepted").find("-\tM118 here\n"), std::string::npos) << file("accepted");
}

TEST_F(Serve, a_second_one_on_the_same_path_is_refused_and_the_first_goes_on) {
  start({});
  const auto second =
      process::capture({.arguments = {stepfabric, "serve", "--speed", "max", "--until", "1",
                                      "--pty", port.string(), "--report", file_path("second")}});
  EXPECT_EQ(second.exit_status, 2);
  EXPECT_NE(second.output.find("port is in use by process "), std::string::npos);
  const int host = open_port();
  EXPECT_TRUE(connect(host));
  close(host);
  EXPECT_EQ(stop(), 0);
}

// What is written there would come to the chip as a host's lines.
TEST_F(Serve, writes_no_file_of_its_own_to_its_port) {
  for (const char* option : {"--edges", "--accept-log"}) {
    const auto refused = process::capture(
        {.arguments = {stepfabric, "serve", "--speed", "max", "--until", "0.1", "--pty",
                       port.string(), option, port.string(), "--report", file_path("report")}});
    EXPECT_EQ(refused.exit_status, 2);
    EXPECT_NE(refused.output.find("would both write"), std::string::npos) << refused.output;
  }
}

// A port that never answers, or does not even take what is written.
TEST_F(Serve, is_not_needed_for_a_load_to_end_at_ctrl_c) {
  const std::string program = file_path("program");
  std::ofstream(program, std::ios::binary) << std::string("\x6f\0\0\0", 4);
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_TRUE(grantpt(master) == 0 && unlockpt(master) == 0);
  process::Process load({.arguments = {stepfabric, "load", program, ptsname(master)}});
  std::this_thread::sleep_for(1s);
  EXPECT_FALSE(load.ending());
  load.signal(SIGINT);
  std::this_thread::sleep_for(1s);
  ASSERT_TRUE(load.ending());
  EXPECT_EQ(load.ending()->exit_status, 128 + SIGINT);
  close(master);
}

// As on a board: the running firmware makes way, and the one that has come takes its place.
TEST_F(Serve, a_firmware_is_loaded_over_the_port_and_answers) {
  start({"--clock-hz", "4000000"});
  const process::Start load{
      .arguments = {stepfabric, "load", BUILD_DIRECTORY "/firmware/firmware.elf", port.string()}};
  EXPECT_EQ(process::capture(load).exit_status, 0);
  const int host = open_port();
  EXPECT_TRUE(connect(host));
  close(host);
  EXPECT_EQ(stop(), 0);
  // With no program at the other end.
  EXPECT_NE(process::capture(load).exit_status, 0);
}

// The whole memory a jump to itself: it looks to a reader of the firmware's words like 111 lines.
TEST_F(Serve, outlives_another_program_and_serves_the_firmware_again) {
  start({"--reset-on-open"});
  const std::string program = file_path("program");
  {
    std::ofstream stream(program, std::ios::binary);
    for (int i = 0; i < 12'500; ++i) stream.write("\x6f\0\0\0", 4);
  }
  const process::Start load{.arguments = {stepfabric, "load", program, port.string()}};
  EXPECT_EQ(process::capture(load).exit_status, 0);
  std::this_thread::sleep_for(2s);
  const int host = open_port();  // resets the chip
  EXPECT_NE(read_until(host, "start\n").find("start\n"), std::string::npos);
  EXPECT_TRUE(connect(host));
  close(host);
  EXPECT_EQ(stop(), 0);
  EXPECT_NE(file("report/report.json").find("\"result\": \"stopped\""), std::string::npos);
  // The memory's contents were never taken for a line.
  EXPECT_EQ(file("accepted").find("o\\x00\\x00\\x00"), std::string::npos) << file("accepted");
}

}  // namespace
