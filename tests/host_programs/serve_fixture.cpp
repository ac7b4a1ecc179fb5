// SPDX-License-Identifier: Apache-2.0
// Starting, ending and talking to the process.
#include "tests/host_programs/serve_fixture.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <iterator>
#include <thread>

#include "directories.hpp"
#include "tools/files/file_text.hpp"

namespace host_programs {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

Serve::Serve()
    : folder_(fs::path(BUILD_DIRECTORY) / "scenarios" /
              testing::UnitTest::GetInstance()->current_test_info()->name()) {
  fs::remove_all(folder_);
  const fs::path runtime = folder_ / "runtime";
  fs::create_directories(runtime);
  fs::permissions(runtime, fs::perms::owner_all);
  port = folder_ / "port";
  setenv("XDG_RUNTIME_DIR", runtime.c_str(), 1);
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
}

Serve::~Serve() {
  if (job_) kill_at_once();
}

void Serve::start(const std::vector<std::string>& options, const char* speed) {
  std::vector<std::string> words{BUILD_DIRECTORY "/bin/stepfabric",
                                 "serve",
                                 "--speed",
                                 speed,
                                 "--pty",
                                 port,
                                 "--report",
                                 folder_ / "report",
                                 "--accept-log",
                                 folder_ / "accepted"};
  words.insert(words.end(), options.begin(), options.end());
  const std::string output = file_path("output");
  fs::remove(output);
  job_.emplace(process::Start{.arguments = words, .output = output});
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (file("output").find("serving ") == std::string::npos && !job_->ending() &&
         std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(50ms);
  }
  ASSERT_TRUE(fs::is_symlink(port));
}

int Serve::stop() {
  job_->signal(SIGINT);
  const int status = job_->wait().exit_status;
  job_.reset();
  return status;
}

void Serve::kill_at_once() {
  job_->signal(SIGKILL);
  job_.reset();
}

std::string Serve::file(const char* name) const { return files::text_of(file_path(name)); }

std::vector<fs::path> Serve::locks() const {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "runtime")) {
    if (entry.path().extension() == ".lock") found.push_back(entry.path());
  }
  return found;
}

int Serve::open_port() const { return open(port.c_str(), O_RDWR | O_NOCTTY); }

std::string Serve::read_until(int descriptor, const std::string& wanted,
                              std::chrono::seconds time) {
  std::string text;
  const auto end = std::chrono::steady_clock::now() + time;
  while (text.find(wanted) == std::string::npos && std::chrono::steady_clock::now() < end) {
    pollfd event{descriptor, POLLIN, 0};
    if (poll(&event, 1, 200) <= 0) continue;
    char byte = 0;
    if (read(descriptor, &byte, 1) == 1) text += byte;
  }
  return text;
}

bool Serve::connect(int descriptor) {
  for (int i = 0; i < 20; ++i) {
    write_text(descriptor, "M105\n");
    if (read_until(descriptor, "ok T:", 5s).find("ok T:") != std::string::npos) return true;
  }
  return false;
}

void Serve::write_text(int descriptor, const std::string& text) {
  ASSERT_EQ(write(descriptor, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

}  // namespace host_programs
