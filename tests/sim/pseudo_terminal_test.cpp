// SPDX-License-Identifier: Apache-2.0
// A host program opens the simulated printer's port, talks, leaves and comes back.
#include "sim/devices/pseudo_terminal.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

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
  devices::PseudoTerminal terminal(link, line, rate);
  simulation.attach(terminal, {});
  EXPECT_EQ(ask("M105\n"), "ok M105\n");
  EXPECT_EQ(ask("N1 G28*18\r\n"), "ok N1 G28*18\r\n");
}

TEST_F(PseudoTerminalTest, survives_hosts_that_close_and_open_the_port) {
  devices::PseudoTerminal terminal(link, line, rate);
  simulation.attach(terminal, {});
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(ask("M105\n"), "ok M105\n");
    simulation.run_until(simulation.now() + rate.clocks(0.01));
  }
}

TEST_F(PseudoTerminalTest, makes_its_symlink_and_removes_it) {
  {
    devices::PseudoTerminal terminal(link, line, rate);
    EXPECT_EQ(fs::read_symlink(link), terminal.slave_path());
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
}

TEST_F(PseudoTerminalTest, replaces_a_stale_symlink_but_no_file) {
  fs::create_symlink("/dev/pts/no-such-terminal", link);
  {
    devices::PseudoTerminal terminal(link, line, rate);
  }
  std::ofstream(link) << "precious";
  EXPECT_THROW(devices::PseudoTerminal(link, line, rate), std::runtime_error);
  EXPECT_EQ(fs::file_size(link), 8U);
  fs::remove(link);
}

}  // namespace
