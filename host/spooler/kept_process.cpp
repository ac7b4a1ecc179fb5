// SPDX-License-Identifier: Apache-2.0
// Notes number and start time of the process in a file.
#include "host/spooler/kept_process.hpp"

#include <fstream>

#include "tools/files/write_file.hpp"

namespace spooler {

namespace {

constexpr std::chrono::seconds start_interval{3};

}  // namespace

KeptProcess::KeptProcess(std::filesystem::path note, std::filesystem::path log,
                         std::vector<std::string> arguments)
    : note_(std::move(note)), log_(std::move(log)), arguments_(std::move(arguments)) {
  std::ifstream(note_) >> identity_.id >> identity_.started;
}

bool KeptProcess::is_running() const { return process::is_running(identity_); }

void KeptProcess::keep_running() {
  const auto now = std::chrono::steady_clock::now();
  if (is_running() || (started_ && now - started_at_ < start_interval)) return;
  started_ = true;
  started_at_ = now;
  identity_ =
      process::start_detached({.arguments = arguments_, .output = log_, .has_input = false});
  is_noted_ = false;
  write_note();
}

void KeptProcess::write_note() {
  if (is_noted_) return;
  files::write_file(note_,
                    std::to_string(identity_.id) + " " + std::to_string(identity_.started) + "\n");
  is_noted_ = true;
}

void KeptProcess::signal(int number) const { process::signal(identity_, number); }

}  // namespace spooler
