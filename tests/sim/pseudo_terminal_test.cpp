// SPDX-License-Identifier: Apache-2.0
// A host program opens the simulated printer's port, talks, leaves and comes back.
#include "sim/devices/pseudo_terminal.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/devices/terminal_settings.hpp"
#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

namespace fs = std::filesystem;
constexpr sim::ClockRate rate(4'000'000);

class PseudoTerminalTest : public testing::Test {
 protected:
  PseudoTerminalTest() {
    fs::remove_all(folder);
    fs::create_directories(folder / "runtime");
    fs::permissions(folder / "runtime", fs::perms::owner_all);
    setenv("XDG_RUNTIME_DIR", (folder / "runtime").c_str(), 1);
    simulation.attach(line, sim::OutputPins::transmit_pin());
    chip.firmware = [](const std::string& text) { return "ok " + text + "\n"; };
  }
  // What a host reads after it has written, while the simulation runs for a while: longer than the
  // line rests after the host before.
  std::string ask(const std::string& text) {
    const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
    EXPECT_GE(port, 0);
    EXPECT_EQ(write(port, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    simulation.run_until(simulation.now() + rate.clocks(0.2));
    std::string answer;
    // The kernel hands bytes over in its own time.
    constexpr int patience_ms = 200;
    pollfd event{port, POLLIN, 0};
    while (!answer.ends_with('\n') && poll(&event, 1, patience_ms) > 0) {
      std::array<char, 100> bytes;
      const ssize_t count = read(port, bytes.data(), bytes.size());
      if (count <= 0) break;
      answer.append(bytes.data(), static_cast<std::size_t>(count));
    }
    close(port);
    return answer;
  }

  static void write_text(int port, const std::string& text) {
    ASSERT_EQ(write(port, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void write_and_close(const std::string& text) const {
    const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
    ASSERT_GE(port, 0);
    write_text(port, text);
    close(port);
  }

  // A file of somebody's, with a text that must stay.
  static void write_precious(const fs::path& file) { std::ofstream(file) << "precious"; }
  static std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder = fs::path(testing::TempDir()) / "stepfabric_pty_test";
  fs::path link = folder / "port";
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
  chip.say("to no host\n");
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
  for (int i = 0; i < 200; ++i) much += "G1 X20\n";  // 47 s
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

TEST_F(PseudoTerminalTest, refuses_a_path_where_a_file_lies) {
  write_precious(link);
  EXPECT_THROW(devices::PseudoTerminal(link, line, rate, 250'000), std::runtime_error);
  EXPECT_EQ(text_of(link), "precious");
}

// Whose it is cannot be seen, also where it leads nowhere.
TEST_F(PseudoTerminalTest, refuses_a_path_with_a_symlink_that_it_has_not_made) {
  for (const char* target : {"/dev/null", "/dev/pts/no-such-terminal"}) {
    fs::create_symlink(target, link);
    EXPECT_THROW(devices::PseudoTerminal(link, line, rate, 250'000), std::runtime_error);
    ASSERT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(fs::read_symlink(link), target);
    fs::remove(link);
  }
}

TEST_F(PseudoTerminalTest, leaves_the_files_alone_whose_names_are_like_the_path) {
  const fs::path lock = link.string() + ".lock", fresh = link.string() + ".new";
  write_precious(lock);
  write_precious(fresh);
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    EXPECT_EQ(text_of(lock), "precious");
    EXPECT_EQ(text_of(fresh), "precious");
  }
  EXPECT_EQ(text_of(lock), "precious");
  EXPECT_EQ(text_of(fresh), "precious");
}

TEST_F(PseudoTerminalTest, writes_through_no_symlink_that_a_neighbour_has_planted) {
  write_precious(folder / "victim");
  for (const char* end : {".lock", ".new"}) {
    fs::create_symlink(folder / "victim", link.string() + end);
  }
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
  }
  EXPECT_EQ(text_of(folder / "victim"), "precious");
  for (const char* end : {".lock", ".new"}) {
    EXPECT_TRUE(fs::is_symlink(link.string() + end)) << end;
  }
}

// In a folder like /tmp, with the first user's environment, as after `su`.
TEST_F(PseudoTerminalTest, leaves_the_symlink_and_the_locks_of_another_user) {
  constexpr uid_t another_user = 65'534;
  const fs::path locks_of_other = "/tmp/stepfabric-" + std::to_string(another_user);
  if (geteuid() != 0 || fs::exists(fs::symlink_status(locks_of_other)))
    GTEST_SKIP() << "only root can become another user, one that has not served yet";
  const fs::path shared = "/tmp/stepfabric_shared_folder_of_a_test";
  fs::remove_all(shared);
  fs::create_directory(shared);
  fs::permissions(shared, fs::perms::all | fs::perms::sticky_bit);
  link = shared / "port";
  enum Result { took_it = 1, refused, could_not_have_its_own };
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    const pid_t child = fork();
    if (child == 0) {
      if (setgid(another_user) != 0 || setuid(another_user) != 0) _exit(0);
      Result result = took_it;
      try {
        devices::PseudoTerminal other(link, line, rate, 250'000);
      } catch (const std::runtime_error&) {
        result = refused;
      }
      try {
        devices::PseudoTerminal own(shared / "own", line, rate, 250'000);
      } catch (const std::runtime_error&) {
        result = could_not_have_its_own;
      }
      _exit(result);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), refused);
    EXPECT_EQ(fs::read_symlink(link), terminal.slave_path());
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
  EXPECT_TRUE(fs::is_empty(shared));
  fs::remove_all(shared);
  EXPECT_TRUE(fs::is_empty(locks_of_other));
  fs::remove(locks_of_other);
}

TEST_F(PseudoTerminalTest, leaves_a_symlink_that_has_taken_the_place_of_its_own) {
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    const fs::path other = folder / "other";
    fs::create_symlink(terminal.slave_path(), other);  // of the same target
    fs::rename(other, link);
  }
  EXPECT_TRUE(fs::is_symlink(link));
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
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
    EXPECT_EQ(fs::read_symlink(link), terminal.slave_path());
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
}

}  // namespace
