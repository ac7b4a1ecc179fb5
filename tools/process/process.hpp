// SPDX-License-Identifier: Apache-2.0
// Child processes: the one place of this project's host programs that starts another program.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace process {

struct Start {
  std::vector<std::string> arguments;  // the program first, looked for along PATH
  std::filesystem::path folder{};  // it runs there; empty: in this process's folder
  std::filesystem::path output{};  // file for standard output; empty: this process's own
  std::filesystem::path errors{};  // file for standard error; empty: where the output goes
  bool to_pipe = false;  // both streams are read through Process::pipe()
  bool has_input = true;  // this process's standard input; false: none
  std::chrono::seconds cpu_limit{0};  // of each process, killed when it has used so much; 0: none
};

struct Ending {
  int exit_status{};  // 128 + signal where a signal ended it, 127 where it was not found
  bool timed_out{};  // at the limit of run(), or at `cpu_limit`
  double cpu_seconds{};  // of the program and of the children that it waited for
};

// A running program, at the head of a process group of its own: what it starts in turn is signalled
// with it. It also ends (SIGTERM) when the thread that started it ends.
class Process {
 public:
  // Throws std::system_error where no process can be made or a file cannot be written.
  explicit Process(const Start& start);
  // Ends the group where the program still runs: SIGTERM, ten seconds later SIGKILL.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // How it ended; none as long as it runs.
  const std::optional<Ending>& ending();
  // Waits for its end.
  Ending wait();
  void signal(int number) const;
  // The reading end of its output with `to_pipe`, owned by this object; -1 without.
  int pipe() const { return pipe_; }

 private:
  bool collect(int options);

  pid_t id_ = 0;
  int pipe_ = -1;
  bool has_cpu_limit_ = false;
  std::optional<Ending> ending_;
};

// Runs a program to its end. It is killed at the limit (0: none), and ended where `look`, which is
// called every few milliseconds, throws.
Ending run(const Start& start, std::chrono::seconds limit = std::chrono::seconds{0},
           const std::function<void()>& look = {});

struct Captured {
  int exit_status{};
  std::string output;  // both streams
};
// Runs a program to its end and collects what it says.
Captured capture(Start start);

// A process that may outlive this one, and is known again by another one.
struct Identity {
  pid_t id = 0;
  std::uint64_t started{};  // since the machine's start, in clock ticks: numbers are used again
  bool operator==(const Identity&) const = default;
};
// Starts a program in a session of its own: it gets no signal of this terminal and goes on when
// this process ends; of this one's files it has the three streams only. Not with `to_pipe`.
// Throws std::system_error.
Identity start_detached(const Start& start);
// False also where the number belongs to another process by now.
bool is_running(const Identity& process);
// To its process group.
void signal(const Identity& process, int number);

// Goes on as another program, with this one's streams and signals. Throws std::runtime_error where
// it cannot be started.
[[noreturn]] void become(const std::vector<std::string>& arguments);

}  // namespace process
