// SPDX-License-Identifier: Apache-2.0
// Making the terminal pair, and moving bytes between it and the simulated line.
#include "sim/devices/pseudo_terminal.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace devices {

namespace {

// Looking for bytes from the host costs a system call, and a byte at 250 kbaud takes 40 us.
constexpr double poll_interval_seconds = 0.0005;
// Bytes that wait for the wire; the kernel holds back the rest, as a USB adapter's buffer would.
constexpr std::size_t line_buffer_bytes = 64;
// What the kernel does not take because no host reads is kept up to this size, then dropped.
constexpr std::size_t host_buffer_bytes = 65'536;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::filesystem::path& link, SerialLine& line,
                               sim::ClockRate rate)
    : link_(link), line_(line), poll_interval_(rate.clocks(poll_interval_seconds) + 1) {
  if (std::filesystem::exists(std::filesystem::symlink_status(link)) &&
      !std::filesystem::is_symlink(link)) {
    throw std::runtime_error(link.string() + " exists and is not a symlink");
  }
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) {
    fail("cannot make a pseudo-terminal");
  }
  std::array<char, 128> name{};
  if (ptsname_r(master_, name.data(), name.size()) != 0) {
    fail("cannot name the pseudo-terminal");
  }
  slave_path_ = name.data();
  slave_ = open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  if (slave_ < 0 || tcgetattr(slave_, &settings) != 0) {
    fail("cannot open the pseudo-terminal");
  }
  cfmakeraw(&settings);
  cfsetspeed(&settings, B115200);
  if (tcsetattr(slave_, TCSANOW, &settings) != 0) {
    fail("cannot set the pseudo-terminal");
  }
  std::filesystem::remove(link);
  std::filesystem::create_symlink(slave_path_, link);
  line_.set_listener(*this);
  next_wake_ = poll_interval_;
}

PseudoTerminal::~PseudoTerminal() {
  std::error_code ignored;
  if (std::filesystem::read_symlink(link_, ignored) == slave_path_) {
    std::filesystem::remove(link_, ignored);
  }
  close(slave_);
  close(master_);
}

void PseudoTerminal::wake(sim::Clock now) {
  next_wake_ = now + poll_interval_;
  flush();
  if (line_.waiting_bytes() >= line_buffer_bytes) {
    return;
  }
  std::array<char, line_buffer_bytes> buffer{};
  const ssize_t count = read(master_, buffer.data(), buffer.size());
  if (count > 0) {
    line_.send(now, std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  }
}

void PseudoTerminal::byte_received(sim::Clock, std::uint8_t byte) {
  to_host_ += static_cast<char>(byte);
  if (byte == '\n') {
    flush();
  }
  if (to_host_.size() > host_buffer_bytes) {
    bytes_dropped_ += to_host_.size();
    to_host_.clear();
  }
}

void PseudoTerminal::flush() {
  if (to_host_.empty()) {
    return;
  }
  const ssize_t count = write(master_, to_host_.data(), to_host_.size());
  if (count > 0) {
    to_host_.erase(0, static_cast<std::size_t>(count));
  }
}

}  // namespace devices
