// SPDX-License-Identifier: Apache-2.0
// Creates the terminal pair and its symlink, and transmits the chip's bytes.
#include "sim/devices/pseudo_terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "sim/devices/terminal_settings.hpp"

namespace devices {

namespace {

// Looking for bytes from the host costs a system call, and a byte at 250 kbaud takes 40 us.
constexpr double poll_interval_seconds = 0.0005;
// Bytes that the kernel does not accept because the host does not read are kept up to this size,
// then dropped.
constexpr std::size_t host_buffer_bytes = 65'536;

// Which symlink of this user it is: file system, inode, time of its making, target. Empty where
// there is none, or another user's.
std::string identity_of_link(const std::filesystem::path& path) {
  struct stat found{};
  std::error_code error;
  if (lstat(path.c_str(), &found) != 0 || !S_ISLNK(found.st_mode) || found.st_uid != geteuid()) {
    return {};
  }
  return fmt::format("{} {} {}.{} {}", found.st_dev, found.st_ino, found.st_ctim.tv_sec,
                     found.st_ctim.tv_nsec, std::filesystem::read_symlink(path, error).string());
}

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::filesystem::path& link, SerialLine& line,
                               sim::ClockRate rate, std::uint32_t baud)
    : link_(link),
      lock_(link),
      line_(line),
      rate_(rate),
      poll_interval_(rate.clocks(poll_interval_seconds) + 1),
      chip_baud_(baud),
      host_baud_(baud) {
  try {
    make_slave();
    make_link();
  } catch (...) {
    release();
    throw;
  }
  line_.set_listener(*this);
  next_wake_ = poll_interval_;
}

void PseudoTerminal::make_slave() {
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) {
    fail("cannot make a pseudo-terminal");
  }
  std::array<char, 128> name{};
  if (ptsname_r(master_, name.data(), name.size()) != 0) fail("cannot name the pseudo-terminal");
  slave_path_ = name.data();
  // A terminal reports that it is not open only after its first use.
  const int slave = open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave < 0) fail("cannot open the pseudo-terminal");
  close(slave);
  set_raw(master_, chip_baud_);
  watch_.emplace(slave_path_);
}

// Nothing but what a process of this user made here and could not remove gives way. The lock's note
// says which one that is.
void PseudoTerminal::make_link() {
  const std::string stale = lock_.note_left_behind();
  if (!stale.empty() && identity_of_link(link_) == stale) std::filesystem::remove(link_);
  // Does not follow and does not replace what stands there.
  if (symlink(slave_path_.c_str(), link_.c_str()) != 0) {
    const int error = errno;
    if (error == EEXIST) {
      throw std::runtime_error(link_.string() +
                               " exists already, and is not a symlink that a `serve` of yours has "
                               "left behind: remove it or choose another path");
    }
    throw std::system_error(error, std::generic_category(), link_.string());
  }
  identity_ = identity_of_link(link_);
  lock_.note(identity_);
}

PseudoTerminal::~PseudoTerminal() { release(); }

void PseudoTerminal::release() {
  remove_link();
  if (master_ >= 0) close(master_);
}

void PseudoTerminal::remove_link() {
  if (identity_.empty() || identity_of_link(link_) != identity_) return;
  std::error_code ignored;
  std::filesystem::remove(link_, ignored);
}

// A host has had the terminal for itself (TIOCEXCL) and was killed: no user can open it any more.
void PseudoTerminal::renew() {
  remove_link();
  close(std::exchange(master_, -1));
  make_slave();
  make_link();
}

void PseudoTerminal::byte_received(sim::Clock now, std::uint8_t byte) {
  if (on_byte) on_byte(now, static_cast<char>(byte));
  if (!connected_ || leaving_) return;
  to_host_ += static_cast<char>(byte);
  if (byte == '\n') flush();
  if (to_host_.size() > host_buffer_bytes) {
    bytes_dropped_ += to_host_.size();
    to_host_.clear();
  }
}

void PseudoTerminal::flush() {
  if (to_host_.empty()) return;
  const ssize_t count = write(master_, to_host_.data(), to_host_.size());
  if (count > 0) to_host_.erase(0, static_cast<std::size_t>(count));
}

}  // namespace devices
