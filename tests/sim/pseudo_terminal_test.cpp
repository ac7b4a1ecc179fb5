// SPDX-License-Identifier: Apache-2.0
// A host program opens the simulated printer's port, talks, leaves and comes back.
#include "sim/devices/pseudo_terminal.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "sim/devices/terminal_settings.hpp"
#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

namespace fs = std::filesystem;
constexpr sim::ClockRate rate(4'000'000);

class PseudoTerminalTest : public testing::Test {
 protected:
  PseudoTerminalTest() {
    simulation.attach(line, sim::OutputPins::transmit_pin());
    chip.firmware = [](const std::string& text) { return "ok " + text + "\n"; };
  }
  // What a host reads after it has written, while the simulation runs for a while.
  std::string ask(const std::string& text) {
    const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
    EXPECT_GE(port, 0);
    EXPECT_EQ(write(port, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    simulation.run_until(simulation.now() + rate.clocks(0.05));
    std::string answer(100, '\0');
    fcntl(port, F_SETFL, O_NONBLOCK);
    const ssize_t count = read(port, answer.data(), answer.size());
    answer.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    close(port);
    return answer;
  }

  fs::path link = fs::path(testing::TempDir()) / "stepfabric_pty_test";
  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
  devices::SerialLine line{rate, 250'000, chip.inputs()};
};

TEST_F(PseudoTerminalTest, carries_a_dialogue_without_echo_or_translation) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  EXPECT_EQ(ask("M105\n"), "ok M105\n");
  EXPECT_EQ(ask("N1 G28*18\r\n"), "ok N1 G28*18\r\n");
}

TEST_F(PseudoTerminalTest, survives_hosts_that_close_and_open_the_port) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(ask("M105\n"), "ok M105\n");
    simulation.run_until(simulation.now() + rate.clocks(0.01));
  }
}

TEST_F(PseudoTerminalTest, gives_a_new_host_nothing_that_was_said_to_the_one_before) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  int opened = 0, closed = 0;
  terminal.on_open = [&](sim::Clock) { ++opened; };
  terminal.on_close = [&](sim::Clock) { ++closed; };
  chip.say("to nobody\n");
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_FALSE(terminal.connected());
  // One that never reads, and is gone in the midst of a line.
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  ASSERT_EQ(write(port, "M105\nM10", 8), 8);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_TRUE(terminal.connected());
  close(port);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  EXPECT_FALSE(terminal.connected());
  EXPECT_EQ(ask("9\n"), "ok M109\n");
  EXPECT_EQ(opened, 2);
  EXPECT_EQ(closed, 1);
}

TEST_F(PseudoTerminalTest, runs_the_wire_at_the_speed_that_the_host_chooses) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  devices::set_raw(port, 115'200);
  ASSERT_EQ(write(port, "M105\n", 5), 5);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_EQ(terminal.host_baud(), 115'200U);
  close(port);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  EXPECT_EQ(terminal.host_baud(), 250'000U);
  ask("\n");  // ends the noise that the chip has heard
  EXPECT_EQ(ask("M105\n"), "ok M105\n");
}

TEST_F(PseudoTerminalTest, forgets_what_a_host_does_not_read_but_stays_alive) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  chip.say(std::string(120'000, 'x') + "\n");
  simulation.run_until(simulation.now() + rate.clocks(5.0));
  EXPECT_GT(terminal.bytes_dropped(), 0U);
  close(port);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  EXPECT_EQ(ask("M105\n"), "ok M105\n");
}

TEST_F(PseudoTerminalTest, makes_its_symlink_and_removes_it) {
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    EXPECT_EQ(fs::read_symlink(link), terminal.slave_path());
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
}

TEST_F(PseudoTerminalTest, replaces_a_stale_symlink_but_no_file) {
  fs::create_symlink("/dev/pts/no-such-terminal", link);
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
  }
  std::ofstream(link) << "precious";
  EXPECT_THROW(devices::PseudoTerminal(link, line, rate, 250'000), std::runtime_error);
  EXPECT_EQ(fs::file_size(link), 8U);
  fs::remove(link);
}

TEST_F(PseudoTerminalTest, leaves_the_symlink_of_another_that_is_still_served) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  devices::SerialLine other_line{rate, 250'000, chip.inputs()};
  try {
    devices::PseudoTerminal other(link, other_line, rate, 250'000);
    ADD_FAILURE() << "two serve one port";
  } catch (const std::runtime_error& refusal) {
    EXPECT_EQ(refusal.what(), link.string() + " is in use by process " + std::to_string(getpid()));
  }
  EXPECT_EQ(fs::read_symlink(link), terminal.slave_path());
  EXPECT_EQ(ask("M105\n"), "ok M105\n");
}

TEST_F(PseudoTerminalTest, takes_the_path_of_one_that_has_died) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    _exit(0);  // without destructors
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::is_symlink(link));
  ASSERT_TRUE(fs::exists(link.string() + ".lock"));
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    EXPECT_EQ(fs::read_symlink(link), terminal.slave_path());
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
  EXPECT_FALSE(fs::exists(link.string() + ".lock"));
}

}  // namespace
