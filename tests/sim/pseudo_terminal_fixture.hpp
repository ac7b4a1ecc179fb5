// SPDX-License-Identifier: Apache-2.0
// A chip that answers on a serial line, and a host at the path of a pseudo-terminal.
#pragma once

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "sim/devices/pseudo_terminal.hpp"
#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace tests {

class PseudoTerminalTest : public testing::Test {
 protected:
  static constexpr sim::ClockRate rate{4'000'000};

  PseudoTerminalTest() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "runtime");
    std::filesystem::permissions(folder / "runtime", std::filesystem::perms::owner_all);
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

  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "stepfabric_pty_test";
  std::filesystem::path link = folder / "port";
  FakeChip chip;
  sim::Simulation simulation{chip, rate};
  devices::SerialLine line{rate, 250'000, chip.inputs()};
};

}  // namespace tests
