// SPDX-License-Identifier: Apache-2.0
// A host that opens the port right after another one, before the pseudo-terminal has looked.
#include <string>
#include <vector>

#include "tests/sim/pseudo_terminal_fixture.hpp"

namespace {

using tests::PseudoTerminalTest;
using Lines = std::vector<std::string>;

class PseudoTerminalChange : public PseudoTerminalTest {
 protected:
  PseudoTerminalChange() {
    simulation.attach(terminal, {});
    chip.firmware = [this](const std::string& came) {
      lines.push_back(came);
      return std::string();
    };
    terminal.on_open = [this](sim::Clock) { ++opened; };
  }
  int open_port() const { return open(link.c_str(), O_RDWR | O_NOCTTY); }
  void run(double seconds) { simulation.run_until(simulation.now() + rate.clocks(seconds)); }

  devices::PseudoTerminal terminal{link, line, rate, 250'000};
  Lines lines;
  int opened = 0;
};

TEST_F(PseudoTerminalChange, gives_the_new_host_no_half_line_to_complete) {
  int port = open_port();
  write_text(port, "M105\nG1 X7");
  run(0.01);
  close(port);
  port = open_port();
  write_text(port, "\nM114\n");
  run(0.3);
  EXPECT_EQ(lines, (Lines{"M105", "", "M114"}));
  EXPECT_EQ(opened, 2);
  close(port);
}

TEST_F(PseudoTerminalChange, forgets_what_the_old_host_wrote_last_of_a_line) {
  int port = open_port();
  write_text(port, "M105\nG1 ");
  run(0.01);
  write_text(port, "X7");
  close(port);
  port = open_port();
  run(0.01);
  write_text(port, "\nM114\n");
  run(0.3);
  EXPECT_EQ(lines, (Lines{"M105", "", "M114"}));
  close(port);
}

// Which of them wrote the rest of the line is not known.
TEST_F(PseudoTerminalChange, drops_a_half_line_s_rest_that_either_may_have_written) {
  int port = open_port();
  write_text(port, "M105\nG1 ");
  run(0.01);
  write_text(port, "X7");
  close(port);
  port = open_port();
  write_text(port, "0");
  run(0.2);
  write_text(port, "1\nM114\n");
  run(0.2);
  EXPECT_EQ(lines, (Lines{"M105", "M114"}));
  close(port);
}

// As `echo` three times in a script.
TEST_F(PseudoTerminalChange, takes_the_whole_lines_of_hosts_that_only_write_and_close) {
  for (const char* text : {"M118 a\n", "M118 b\n", "M118 c\n"}) write_and_close(text);
  run(0.01);
  write_and_close("M118 d\n");
  const int port = open_port();
  run(0.5);
  EXPECT_EQ(lines, (Lines{"M118 a", "M118 b", "M118 c", "M118 d"}));
  close(port);
}

// As `stty` in the middle of a job.
TEST_F(PseudoTerminalChange,
       is_none_where_another_program_opens_and_closes_while_the_host_is_there) {
  const int port = open_port();
  write_text(port, "M1");
  run(0.01);
  close(open(link.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK));
  run(0.01);
  close(open(link.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK));
  write_text(port, "14\n");
  run(0.2);
  EXPECT_EQ(lines, Lines{"M114"});
  EXPECT_EQ(opened, 1);
  close(port);
}

TEST_F(PseudoTerminalChange, is_seen_many_times_in_a_row) {
  int port = open_port();
  for (int i = 0; i < 50; ++i) {
    write_text(port, "G1 X7");
    run(0.2);
    close(port);
    port = open_port();
    write_text(port, "\n");
    run(0.2);
  }
  EXPECT_EQ(lines, Lines(50, ""));
  EXPECT_EQ(opened, 51);
  close(port);
}

}  // namespace
