// SPDX-License-Identifier: Apache-2.0
// Child processes, each the head of a process group of its own.
#include "tools/proof/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

namespace proof {

namespace {

constexpr std::chrono::milliseconds look_interval{10};

[[noreturn]] void become(std::vector<char*>& arguments, const std::string& folder,
                         const std::string& log, const std::string& error_log, rlim_t cpu_seconds) {
  setpgid(0, 0);
  if (cpu_seconds != 0) {
    const rlimit limit{cpu_seconds, cpu_seconds};
    setrlimit(RLIMIT_CPU, &limit);
  }
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const int errors = open(error_log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || errors < 0 || chdir(folder.c_str()) != 0) {
    _exit(126);
  }
  dup2(file, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  execvp(arguments.front(), arguments.data());
  _exit(127);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, const std::filesystem::path& log,
                          std::chrono::seconds limit, std::chrono::seconds cpu_limit) {
  // All that allocates is done before the fork: other threads may hold the heap's lock then.
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  const std::string folder_name = folder.string();
  const std::string log_name = log.string();
  const std::string error_log_name = log_name + ".err";
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error("cannot start " + arguments.front());
  }
  if (child == 0) {
    become(pointers, folder_name, log_name, error_log_name, static_cast<rlim_t>(cpu_limit.count()));
  }
  const auto end = std::chrono::steady_clock::now() + limit;
  ProcessResult result;
  int status = 0;
  rusage use{};
  while (wait4(child, &status, WNOHANG, &use) == 0) {
    if (std::chrono::steady_clock::now() >= end) {
      result.timed_out = true;
      kill(-child, SIGKILL);
      wait4(child, &status, 0, &use);
      break;
    }
    std::this_thread::sleep_for(look_interval);
  }
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  result.cpu_seconds = seconds(use.ru_utime) + seconds(use.ru_stime);
  // At a hard limit equal to the soft one the kernel sends SIGKILL.
  if (cpu_limit.count() != 0 && WIFSIGNALED(status) &&
      (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    result.timed_out = true;
  }
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace proof
