// SPDX-License-Identifier: Apache-2.0
// One piece of work at a time in another thread.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace spooler {

class Background {
 public:
  Background() = default;
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  bool is_idle() const { return !thread_.joinable(); }
  void begin(std::function<void()> work);
  // Once, when the work is over: what it threw, or nothing.
  std::optional<std::string> take_fault();

 private:
  std::thread thread_;
  std::string fault_;
  std::atomic<bool> done_ = false;
};

}  // namespace spooler
