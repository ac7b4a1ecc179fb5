// SPDX-License-Identifier: Apache-2.0
// Linux's calls for a terminal that never blocks.
#include "host/feeder/port.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "sim/devices/terminal_settings.hpp"

namespace feeder {

namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

Port::Port(std::filesystem::path path, std::uint32_t baud) : path_(std::move(path)), baud_(baud) {}

Port::~Port() { close(); }

bool Port::open() {
  try {
    file_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0) fail("cannot open " + path_.string());
    if (isatty(file_) == 0) fail(path_.string() + " is no serial port");
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) fail("another program uses " + path_.string());
    devices::set_raw(file_, baud_);
    fault_.clear();
  } catch (const std::system_error& error) {
    close();
    fault_ = error.what();
  }
  return file_ >= 0;
}

void Port::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  fault_ = path_.string() + " was closed: unplugged, or its printer was switched off";
}

std::size_t Port::write(std::string_view bytes) {
  if (file_ < 0 || bytes.empty()) return 0;
  const ssize_t count = ::write(file_, bytes.data(), bytes.size());
  if (count >= 0) return static_cast<std::size_t>(count);
  if (errno != EAGAIN && errno != EINTR) close();
  return 0;
}

std::string Port::read() {
  std::string text;
  std::array<char, 4096> buffer{};
  while (file_ >= 0) {
    const ssize_t count = ::read(file_, buffer.data(), buffer.size());
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
      break;
    } else {
      close();
    }
  }
  return text;
}

}  // namespace feeder
