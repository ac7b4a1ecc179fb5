// SPDX-License-Identifier: Apache-2.0
// fork() and exec(), with the files opened and all memory allocated before the fork: other threads
// may hold the heap's lock then.
#include "tools/process/process.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace process {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds look_interval{10};
constexpr std::chrono::seconds grace{10};

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// A file descriptor that is closed at the end of its scope, and in every program that is started.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

Descriptor opened(const std::filesystem::path& file, int mode) {
  Descriptor descriptor(open(file.c_str(), mode | O_CLOEXEC, 0644));
  if (descriptor.number() < 0) fail("cannot open " + file.string());
  return descriptor;
}

// What execvp() wants.
std::vector<char*> pointers_to(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  return pointers;
}

// Where the streams of the program lead; -1: where this process's lead.
struct Streams {
  Descriptor input, output, errors, reading_end;

  explicit Streams(const Start& start) {
    if (!start.has_input) input = opened("/dev/null", O_RDONLY);
    if (start.to_pipe) {
      std::array<int, 2> ends{};
      if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot make a pipe");
      reading_end = Descriptor(ends[0]);
      output = Descriptor(ends[1]);
    } else if (!start.output.empty()) {
      output = opened(start.output, O_WRONLY | O_CREAT | O_TRUNC);
    }
    if (!start.errors.empty()) errors = opened(start.errors, O_WRONLY | O_CREAT | O_TRUNC);
  }
};

// Libraries open files and sockets that exec() would leave open: a detached program would hold a
// connection of its parent after the parent's end.
void close_others_at_exec() {
  constexpr int first = 3, last_usual = 1023;
  if (close_range(first, ~0u, CLOSE_RANGE_CLOEXEC) == 0) return;
  for (int i = first; i <= last_usual; ++i) {
    fcntl(i, F_SETFD, FD_CLOEXEC);  // Linux before 5.11
  }
}

// In the child, which may only call what is safe in a signal handler.
enum class Tie { to_this_thread, none };
[[noreturn]] void execute(char* const* arguments, const char* folder, const Streams& streams,
                          rlim_t cpu_seconds, Tie tie) {
  if (tie == Tie::none) {
    setsid();
    close_others_at_exec();
  } else {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
  }
  ::signal(SIGPIPE, SIG_DFL);
  if (cpu_seconds != 0) {
    const rlimit limit{cpu_seconds, cpu_seconds};
    setrlimit(RLIMIT_CPU, &limit);
  }
  const int output = streams.output.number();
  const int errors = streams.errors.number() >= 0 ? streams.errors.number() : output;
  const bool ready = (streams.input.number() < 0 || dup2(streams.input.number(), 0) == 0) &&
                     (output < 0 || dup2(output, 1) == 1) && (errors < 0 || dup2(errors, 2) == 2) &&
                     (*folder == '\0' || chdir(folder) == 0);
  if (ready) execvp(arguments[0], arguments);
  _exit(ready ? 127 : 126);
}

// The 22nd field of its line in /proc; a name in brackets, with any bytes, is the second. None of
// one that has ended and was not waited for.
std::optional<std::uint64_t> start_of(pid_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t bracket = text.rfind(')');
  if (bracket == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(bracket + 1));
  std::string field;
  constexpr int number_after_name = 20;
  for (int i = 0; i < number_after_name; ++i) {
    fields >> field;
    if (i == 0 && field == "Z") return std::nullopt;
  }
  return std::stoull(field);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

Process::Process(const Start& start) : has_cpu_limit_(start.cpu_limit.count() != 0) {
  const std::vector<char*> arguments = pointers_to(start.arguments);
  const std::string folder = start.folder.string();
  const auto cpu_seconds = static_cast<rlim_t>(start.cpu_limit.count());
  Streams streams(start);
  std::fflush(nullptr);
  id_ = fork();
  if (id_ < 0) fail("cannot start " + start.arguments.front());
  if (id_ == 0) {
    execute(arguments.data(), folder.c_str(), streams, cpu_seconds, Tie::to_this_thread);
  }
  setpgid(id_, id_);  // whichever process comes first
  pipe_ = streams.reading_end.release();
}

Process::~Process() {
  if (!ending_) {
    signal(SIGTERM);
    const auto end = Clock::now() + grace;
    while (!collect(WNOHANG) && Clock::now() < end) std::this_thread::sleep_for(look_interval);
    signal(SIGKILL);
    wait();
  }
  if (pipe_ >= 0) close(pipe_);
}

bool Process::collect(int options) {
  int status = 0;
  rusage use{};
  if (ending_ || wait4(id_, &status, options, &use) != id_) return ending_.has_value();
  const int killer = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  ending_ = {.exit_status = killer == 0 ? WEXITSTATUS(status) : 128 + killer,
             // At a hard limit equal to the soft one the kernel sends SIGKILL.
             .timed_out = has_cpu_limit_ && (killer == SIGXCPU || killer == SIGKILL),
             .cpu_seconds = seconds(use.ru_utime) + seconds(use.ru_stime)};
  return true;
}

const std::optional<Ending>& Process::ending() {
  collect(WNOHANG);
  return ending_;
}

Ending Process::wait() {
  while (!collect(0)) {
  }
  return *ending_;
}

void Process::signal(int number) const { kill(-id_, number); }

Ending run(const Start& start, std::chrono::seconds limit, const std::function<void()>& look) {
  Process process(start);
  const auto end = Clock::now() + limit;
  while (!process.ending()) {
    if (limit.count() != 0 && Clock::now() >= end) {
      process.signal(SIGKILL);
      Ending ending = process.wait();
      ending.timed_out = true;
      return ending;
    }
    if (look) look();
    std::this_thread::sleep_for(look_interval);
  }
  return *process.ending();
}

Captured capture(Start start) {
  start.to_pipe = true;
  Process process(start);
  Captured captured;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 1; count > 0;) {
    count = read(process.pipe(), buffer.data(), buffer.size());
    if (count > 0) captured.output.append(buffer.data(), static_cast<std::size_t>(count));
  }
  captured.exit_status = process.wait().exit_status;
  return captured;
}

Identity start_detached(const Start& start) {
  const std::vector<char*> arguments = pointers_to(start.arguments);
  const std::string folder = start.folder.string();
  const auto cpu_seconds = static_cast<rlim_t>(start.cpu_limit.count());
  const Streams streams(start);
  std::fflush(nullptr);
  const pid_t id = fork();
  if (id < 0) fail("cannot start " + start.arguments.front());
  if (id == 0) execute(arguments.data(), folder.c_str(), streams, cpu_seconds, Tie::none);
  // Until it has a session of its own, for signals go to its group. One that ended keeps it.
  for (int i = 0; i < 1'000 && getsid(id) != id && getsid(id) >= 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return {.id = id, .started = start_of(id).value_or(0)};
}

bool is_running(const Identity& process) {
  if (process.id <= 0) return false;
  waitpid(process.id, nullptr, WNOHANG);  // where it is a child of this process
  return start_of(process.id) == process.started;
}

void signal(const Identity& process, int number) {
  if (is_running(process)) kill(-process.id, number);
}

void become(const std::vector<std::string>& arguments) {
  std::fflush(nullptr);
  execvp(arguments.front().c_str(), pointers_to(arguments).data());
  throw std::runtime_error("cannot start " + arguments.front());
}

}  // namespace process
