// SPDX-License-Identifier: Apache-2.0
// A thread between terminal and printer.
#include "tests/host/pty_printer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <utility>

#include "sim/devices/terminal_settings.hpp"

namespace host_test {

using namespace std::chrono_literals;

PtyPrinter::PtyPrinter(std::filesystem::path path) : path_(std::move(path)) {
  plug_in();
  thread_ = std::thread([this] { run(); });
}

PtyPrinter::~PtyPrinter() {
  ends_ = true;
  thread_.join();
  unplug();
}

void PtyPrinter::plug_in() {
  const std::scoped_lock lock(mutex_);
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) throw std::bad_alloc();
  const std::string name = ptsname(master_);
  slave_ = open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  devices::set_raw(slave_, 250'000);
  std::filesystem::remove(path_);
  std::filesystem::create_symlink(name, path_);
}

void PtyPrinter::unplug() {
  const std::scoped_lock lock(mutex_);
  if (master_ >= 0) close(master_);
  if (slave_ >= 0) close(slave_);
  master_ = slave_ = -1;
  std::filesystem::remove(path_);
}

void PtyPrinter::with(const std::function<void(LinkPrinter&)>& action) {
  const std::scoped_lock lock(mutex_);
  action(printer_);
}

std::vector<std::string> PtyPrinter::executed() {
  const std::scoped_lock lock(mutex_);
  return printer_.executed;
}

void PtyPrinter::run() {
  while (!ends_) {
    {
      const std::scoped_lock lock(mutex_);
      const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(
          std::chrono::steady_clock::now().time_since_epoch());
      std::array<char, 1024> buffer{};
      const ssize_t count = master_ < 0 ? 0 : read(master_, buffer.data(), buffer.size());
      if (count > 0) {
        if (damage_.exchange(false)) buffer.front() ^= 1;
        printer_.receive({buffer.data(), static_cast<std::size_t>(count)}, now);
      }
      const std::string replies = printer_.work(now);
      if (master_ >= 0 && !replies.empty() && write(master_, replies.data(), replies.size()) < 0) {
        // The host reads nothing: as over a real cable, it is lost.
      }
    }
    std::this_thread::sleep_for(1ms);
  }
}

}  // namespace host_test
