// SPDX-License-Identifier: Apache-2.0
// A host program opens the simulated printer's port, talks, leaves and comes back.
#include <termios.h>

#include <string>
#include <vector>

#include "sim/devices/terminal_settings.hpp"
#include "tests/sim/pseudo_terminal_fixture.hpp"

namespace {

using tests::PseudoTerminalTest;

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
  chip.say("to no host\n");
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_FALSE(terminal.connected());
  // One that never reads, and is gone in the middle of a line.
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  ASSERT_EQ(write(port, "M105\nM10", 8), 8);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_TRUE(terminal.connected());
  close(port);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  EXPECT_FALSE(terminal.connected());
  EXPECT_EQ(ask("9\n"), "ok 9\n");
  EXPECT_EQ(opened, 2);
  EXPECT_EQ(closed, 1);
}

TEST_F(PseudoTerminalTest, gives_a_new_host_s_line_end_no_half_line_to_complete) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  std::vector<std::string> lines;
  chip.firmware = [&](const std::string& came) {
    lines.push_back(came);
    return std::string();
  };
  write_and_close("M105\nG1 X7");
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  write_and_close("\nM114\n");
  simulation.run_until(simulation.now() + rate.clocks(0.3));
  EXPECT_EQ(lines, (std::vector<std::string>{"M105", "", "M114"}));
}

// As Linux does for a real port: a script may write and close.
TEST_F(PseudoTerminalTest, sends_what_a_host_has_written_after_it_has_closed) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  std::string text;
  chip.firmware = [&](const std::string& came) {
    text += came;
    return std::string();
  };
  std::string sent;
  for (int i = 0; i < 100; ++i) sent += "G1 X" + std::to_string(i) + "\n";
  write_and_close(sent);
  simulation.run_until(simulation.now() + rate.clocks(1.0));
  std::erase(sent, '\n');
  EXPECT_EQ(text, sent);
  EXPECT_FALSE(terminal.connected());
}

// Firmware that is busy must have read the line before it counts the break.
TEST_F(PseudoTerminalTest, rests_between_the_last_byte_of_a_host_and_the_break) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  write_and_close("M118 here\n");
  simulation.run_until(simulation.now() + rate.clocks(0.015));
  EXPECT_EQ(chip.breaks, 0U);
  simulation.run_until(simulation.now() + rate.clocks(0.015));
  EXPECT_EQ(chip.breaks, 1U);
}

TEST_F(PseudoTerminalTest, discards_what_a_slow_host_has_left_when_the_next_one_comes) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  std::vector<std::string> lines;
  chip.firmware = [&](const std::string& came) {
    lines.push_back(came);
    return std::string();
  };
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  devices::set_raw(port, 300);
  std::string much;
  for (int i = 0; i < 200; ++i) {
    much += "G1 X20\n";  // 47 s
  }
  write_text(port, much);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  close(port);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  const int next = open(link.c_str(), O_RDWR | O_NOCTTY);
  devices::set_raw(next, 250'000);
  write_text(next, "M105\n");
  simulation.run_until(simulation.now() + rate.clocks(2.0));
  close(next);
  simulation.run_until(simulation.now() + rate.clocks(2.0));
  EXPECT_EQ(lines, std::vector<std::string>{"M105"});
}

TEST_F(PseudoTerminalTest, discards_what_waits_when_the_host_changes_its_speed) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  std::string heard;
  chip.firmware = [&](const std::string& came) {
    heard += came;
    return std::string();
  };
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  devices::set_raw(port, 300);
  std::string much;
  for (int i = 0; i < 200; ++i) much += "G1 X20\n";
  write_text(port, much);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  devices::set_raw(port, 250'000);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  write_text(port, "\nM105\n");
  simulation.run_until(simulation.now() + rate.clocks(1.0));
  close(port);
  EXPECT_TRUE(heard.ends_with("M105")) << heard;
  EXPECT_EQ(heard.find("X20"), std::string::npos) << heard;
}

TEST_F(PseudoTerminalTest, holds_a_host_s_bytes_back_and_loses_none) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  terminal.on_open = [&](sim::Clock) { terminal.hold_back(true); };
  std::string text;
  chip.firmware = [&](const std::string& came) {
    text += came + ";";
    return std::string();
  };
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  write_text(port, "M105\nM1");
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_EQ(text, "");
  write_text(port, "14\n");
  terminal.hold_back(false);
  simulation.run_until(simulation.now() + rate.clocks(0.05));
  EXPECT_EQ(text, "M105;M114;");
  close(port);
}

// Only the last host's terminal is stopped, not the port.
TEST_F(PseudoTerminalTest, lets_a_host_write_behind_one_that_stopped_its_output) {
  devices::PseudoTerminal terminal(link, line, rate, 250'000);
  simulation.attach(terminal, {});
  const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
  ASSERT_EQ(tcflow(port, TCOOFF), 0);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  close(port);
  simulation.run_until(simulation.now() + rate.clocks(0.01));
  const int next = open(link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  ASSERT_EQ(write(next, "\n", 1), 1);  // otherwise the one that asks would wait forever
  close(next);
  simulation.run_until(simulation.now() + rate.clocks(0.2));
  EXPECT_EQ(ask("M105\n"), "ok M105\n");
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

}  // namespace
