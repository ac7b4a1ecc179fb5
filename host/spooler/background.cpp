// SPDX-License-Identifier: Apache-2.0
// The thread's life.
#include "host/spooler/background.hpp"

#include <exception>
#include <utility>

namespace spooler {

Background::~Background() {
  if (thread_.joinable()) thread_.join();
}

void Background::begin(std::function<void()> work) {
  done_ = false;
  fault_.clear();
  thread_ = std::thread([this, work = std::move(work)] {
    try {
      work();
    } catch (const std::exception& error) {
      fault_ = error.what();
    }
    done_ = true;
  });
}

std::optional<std::string> Background::take_fault() {
  if (!thread_.joinable() || !done_) return std::nullopt;
  thread_.join();
  return std::move(fault_);
}

}  // namespace spooler
