// SPDX-License-Identifier: Apache-2.0
// The path at which a pseudo-terminal is found: made, kept, left to others.
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <iterator>

#include "tests/sim/pseudo_terminal_fixture.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;
using tests::PseudoTerminalTest;

// A user's file, with a text that must stay.
void write_precious(const fs::path& file) { std::ofstream(file) << "precious"; }

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
  EXPECT_EQ(files::text_of(link), "precious");
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
    EXPECT_EQ(files::text_of(lock), "precious");
    EXPECT_EQ(files::text_of(fresh), "precious");
  }
  EXPECT_EQ(files::text_of(lock), "precious");
  EXPECT_EQ(files::text_of(fresh), "precious");
}

TEST_F(PseudoTerminalTest, writes_through_no_symlink_that_a_neighbour_has_planted) {
  write_precious(folder / "victim");
  for (const char* end : {".lock", ".new"}) {
    fs::create_symlink(folder / "victim", link.string() + end);
  }
  {
    devices::PseudoTerminal terminal(link, line, rate, 250'000);
  }
  EXPECT_EQ(files::text_of(folder / "victim"), "precious");
  for (const char* end : {".lock", ".new"}) EXPECT_TRUE(fs::is_symlink(link.string() + end)) << end;
}

// In a folder like /tmp, with the first user's environment, as after `su`.
TEST_F(PseudoTerminalTest, leaves_the_symlink_and_the_locks_of_another_user) {
  constexpr uid_t another_user = 65'534;
  const fs::path locks_of_other = "/tmp/stepfabric-" + std::to_string(another_user);
  if (geteuid() != 0 || fs::exists(fs::symlink_status(locks_of_other))) {
    GTEST_SKIP() << "only root can become another user, one that has not served yet";
  }
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

// As programs do that want the port for themselves. To root it opens nevertheless.
TEST_F(PseudoTerminalTest, opens_to_the_next_host_behind_one_that_was_killed_with_it_for_itself) {
  const fs::path shared = "/tmp/stepfabric_exclusive_port_of_a_test";
  fs::remove_all(shared);
  fs::create_directory(shared);
  fs::permissions(shared, fs::perms::all);
  link = shared / "port";
  enum Result { opened = 1, refused, link_left_behind };
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t another_user = 65'534;
    if (geteuid() == 0 && (setgid(another_user) != 0 || setuid(another_user) != 0)) _exit(0);
    setenv("XDG_RUNTIME_DIR", (shared / "runtime").c_str(), 1);
    mkdir((shared / "runtime").c_str(), 0700);
    Result result = refused;
    {
      devices::PseudoTerminal terminal(link, line, rate, 250'000);
      simulation.attach(terminal, {});
      const int port = open(link.c_str(), O_RDWR | O_NOCTTY);
      ioctl(port, TIOCEXCL);
      simulation.run_until(simulation.now() + rate.clocks(0.01));
      close(port);
      simulation.run_until(simulation.now() + rate.clocks(0.2));
      if (ask("M105\n") == "ok M105\n") result = opened;
    }
    _exit(fs::exists(fs::symlink_status(link)) ? link_left_behind : result);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), opened);
  fs::remove_all(shared);
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
