// SPDX-License-Identifier: Apache-2.0
// Linux's calls for a terminal.
#include "tools/loading/serial_port.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "sim/devices/terminal_settings.hpp"

namespace loading {

namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

SerialPort::SerialPort(const std::filesystem::path& path, std::uint32_t baud)
    : file_(open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
  if (file_ < 0) fail("cannot open " + path.string());
  try {
    if (isatty(file_) == 0) fail(path.string() + " is no serial port");
    devices::set_raw(file_, baud);
  } catch (...) {
    close(file_);
    throw;
  }
}

SerialPort::~SerialPort() { close(file_); }

void SerialPort::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) fail("cannot write to the serial port");
    if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

std::size_t SerialPort::read(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) {
  pollfd wanted{.fd = file_, .events = POLLIN, .revents = 0};
  const int ready = poll(&wanted, 1, static_cast<int>(timeout.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return 0;
  if (ready < 0) fail("cannot wait for the serial port");
  const ssize_t count = ::read(file_, bytes.data(), bytes.size());
  if (count < 0) fail("cannot read from the serial port");
  if (count == 0) throw LoadFailed("the serial port is gone");
  return static_cast<std::size_t>(count);
}

}  // namespace loading
