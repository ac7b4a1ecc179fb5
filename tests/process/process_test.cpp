// SPDX-License-Identifier: Apache-2.0
// Programs are started as requested, and no process of theirs remains.
#include "tools/process/process.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

using namespace std::chrono_literals;
using process::Start;

Start shell(const std::string& script) { return {.arguments = {"sh", "-c", script}}; }

bool ends_soon(pid_t process) {
  for (int i = 0; i < 500; ++i) {
    // A process that has not been waited for yet is still there, but does nothing any more.
    const std::string status = files::text_of("/proc/" + std::to_string(process) + "/stat");
    if (status.empty() || status.find(") Z ") != std::string::npos) {
      return true;
    }
    std::this_thread::sleep_for(20ms);
  }
  return false;
}

// A shell that starts a sleeper, writes its number into `sleeper`, and waits for it.
class ProcessGroup : public testing::Test {
 protected:
  Start parent() {
    return {.arguments = {"sh", "-c", "sleep 600 & echo $! > sleeper; wait"},
            .folder = folder.path()};
  }
  pid_t sleeper() const {
    pid_t number = 0;
    while (!(std::ifstream(folder.path() / "sleeper") >> number)) std::this_thread::sleep_for(5ms);
    return number;
  }
  TemporaryFolder folder;
};

TEST(process, reports_the_exit_status_the_signal_and_a_missing_program) {
  EXPECT_EQ(process::run(shell("exit 7")).exit_status, 7);
  EXPECT_EQ(process::run(shell("kill -TERM $$")).exit_status, 128 + SIGTERM);
  EXPECT_EQ(process::run({.arguments = {"/no/such/program"}}).exit_status, 127);
}

TEST(process, writes_its_streams_into_the_files_that_are_named) {
  const TemporaryFolder folder;
  Start start = shell("pwd; echo bad >&2");
  start.folder = folder.path();
  start.output = folder.path() / "both";
  process::run(start);
  EXPECT_EQ(files::text_of(start.output), folder.path().string() + "\nbad\n");
  start.output = folder.path() / "output";
  start.errors = folder.path() / "errors";
  process::run(start);
  EXPECT_EQ(files::text_of(start.output), folder.path().string() + "\n");
  EXPECT_EQ(files::text_of(start.errors), "bad\n");
  start.output = folder.path() / "no_folder" / "output";
  EXPECT_THROW(process::run(start), std::runtime_error);
}

TEST(process, collects_what_is_said_more_than_a_pipe_holds) {
  const auto [status, output] = process::capture(shell("seq 100000; echo end >&2; exit 3"));
  EXPECT_EQ(status, 3);
  EXPECT_EQ(output.size(), 588'895U + 4U);
  EXPECT_TRUE(output.ends_with("100000\nend\n"));
}

TEST(process, has_no_input_where_none_is_wanted) {
  Start start = shell("cat");
  start.has_input = false;
  EXPECT_EQ(process::capture(start).output, "");
}

TEST(process, ends_of_a_closed_pipe_though_this_one_ignores_them) {
  const auto before = signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(process::run(shell("kill -PIPE $$; exit 0")).exit_status, 128 + SIGPIPE);
  signal(SIGPIPE, before);
}

TEST(process, is_killed_when_it_has_used_its_processor_time_and_says_how_much) {
  Start start = shell("while :; do :; done");
  start.cpu_limit = 1s;
  const process::Ending ending = process::run(start);
  EXPECT_TRUE(ending.timed_out);
  // The kernel's limit and its account differ by some tenths on a busy virtual machine.
  EXPECT_GE(ending.cpu_seconds, 0.5);
  EXPECT_FALSE(process::run(shell("exit 1")).timed_out);
}

TEST_F(ProcessGroup, is_killed_at_the_limit) {
  const process::Ending ending = process::run(parent(), 1s);
  EXPECT_TRUE(ending.timed_out);
  EXPECT_TRUE(ends_soon(sleeper()));
}

TEST_F(ProcessGroup, ends_where_the_one_who_waits_gives_up) {
  const auto give_up = [this] {
    sleeper();
    throw std::runtime_error("given up");
  };
  EXPECT_THROW(process::run(parent(), {}, give_up), std::runtime_error);
  EXPECT_TRUE(ends_soon(sleeper()));
}

TEST_F(ProcessGroup, gets_the_signals) {
  process::Process process(parent());
  const pid_t number = sleeper();
  EXPECT_FALSE(process.ending());
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait().exit_status, 128 + SIGTERM);
  EXPECT_TRUE(ends_soon(number));
}

TEST(detached_process, has_no_file_of_the_one_that_started_it) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);  // as libraries open them: they stay open at exec()
  const auto sleeper = process::start_detached({.arguments = {"sleep", "600"}});
  close(ends[1]);
  pollfd end{.fd = ends[0], .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&end, 1, 20'000), 1) << "the other end is open";
  close(ends[0]);
  process::signal(sleeper, SIGKILL);
}

TEST(detached_process, goes_on_when_the_thread_that_started_it_ends_and_is_known_by_its_start) {
  process::Identity sleeper;
  std::thread([&sleeper] {
    sleeper = process::start_detached({.arguments = {"sleep", "600"}});
  }).join();
  EXPECT_TRUE(process::is_running(sleeper));
  EXPECT_EQ(getsid(sleeper.id), sleeper.id);
  process::Identity other = sleeper;
  ++other.started;
  EXPECT_FALSE(process::is_running(other));
  process::signal(other, SIGKILL);
  std::this_thread::sleep_for(200ms);
  EXPECT_TRUE(process::is_running(sleeper));
  process::signal(sleeper, SIGKILL);
  for (int i = 0; i < 100 && process::is_running(sleeper); ++i) std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(process::is_running(sleeper));
  EXPECT_FALSE(process::is_running({}));
}

}  // namespace
