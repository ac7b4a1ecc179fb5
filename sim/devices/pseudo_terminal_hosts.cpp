// SPDX-License-Identifier: Apache-2.0
// Hosts that come and go at the pseudo-terminal, and what they write.
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "sim/devices/pseudo_terminal.hpp"
#include "sim/devices/terminal_settings.hpp"

namespace devices {

namespace {

// Bytes that wait for the wire; the kernel holds back the rest, as a USB adapter's buffer would.
constexpr std::size_t line_buffer_bytes = 64;
// As Linux's closing_wait.
constexpr double closing_seconds = 30;
// After a host the line is low for twenty characters at 9600 baud, and then rests for much longer
// than the firmware needs to know that from noise.
constexpr double break_seconds = 0.02;
constexpr double rest_seconds = 0.1;
// As long the line is idle before that (as `port_watch` of the RTL waits): longer than the longest
// pass of the firmware, which must have read the last byte before it counts the break.
constexpr double quiet_seconds = 0.02;

}  // namespace

void PseudoTerminal::wake(sim::Clock now) {
  next_wake_ = now + poll_interval_;
  note_traffic(now);
  const short events = look();
  if ((events & POLLHUP) == 0) {
    if (leaving_) {
      if (left_.empty() && line_.quiet() && now < settled_at_) return;
      host_left(now);
    }
    host_came(now);
    flush();
    take_from_host(now);
    return;
  }
  watch_->start_over(false);
  // It may have connected and disconnected since the last poll.
  if ((events & POLLIN) != 0) host_came(now);
  if (!connected_) return;
  if (!leaving_) keep_what_is_left(now);
  send_what_is_left(now);
}

// A short line goes out between two looks, so this is called after each send as well.
void PseudoTerminal::note_traffic(sim::Clock now) {
  if (!line_.quiet()) settled_at_ = now + rate_.clocks(quiet_seconds);
}

// POLLIN: something to read; POLLHUP: the port is not open.
short PseudoTerminal::look() const {
  pollfd event{master_, POLLIN, 0};
  return poll(&event, 1, 0) > 0 ? event.revents : short{0};
}

void PseudoTerminal::take_from_host(sim::Clock now) {
  follow_speed(now);
  std::string came;
  if (held_back_ || now < rest_until_) {
    unread_ = (look() & POLLIN) != 0;
  } else {
    came = read_from_host();
  }
  // The notes are read after the bytes: where no other host has come, all bytes are this one's.
  const TerminalWatch::Change change = watch_->look();
  if (change.happened) return change_hosts(now, change, std::move(came));
  send(now, came);
}

std::string PseudoTerminal::read_from_host() {
  throttled_ = line_.waiting_bytes() >= line_buffer_bytes;
  unread_ = throttled_;
  if (throttled_) return {};
  if (!early_.empty()) return std::exchange(early_, {});
  std::string bytes(line_buffer_bytes, '\0');
  const ssize_t count = read(master_, bytes.data(), bytes.size());
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  unread_ = throttled_ = bytes.size() == line_buffer_bytes;
  return bytes;
}

std::string PseudoTerminal::read_all() const {
  std::string bytes;
  std::array<char, 4096> buffer;
  for (ssize_t count = 1; count > 0;) {
    count = read(master_, buffer.data(), buffer.size());
    if (count > 0) bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return bytes;
}

void PseudoTerminal::send(sim::Clock now, std::string_view bytes) {
  if (skips_line_) {
    const std::size_t end = bytes.find('\n');
    skips_line_ = end == std::string_view::npos;
    bytes.remove_prefix(skips_line_ ? bytes.size() : end + 1);
  }
  if (bytes.empty()) return;
  in_line_ = bytes.back() != '\n';
  line_.send(now, bytes);
  note_traffic(now);
}

// The new host has opened the port before it was seen that the old one had closed it.
void PseudoTerminal::change_hosts(sim::Clock now, TerminalWatch::Change change, std::string came) {
  const bool old_bytes = change.old_host_wrote || unread_;
  came += read_all();
  const TerminalWatch::Change behind = watch_->look();
  const bool new_bytes = change.new_host_wrote || behind.old_host_wrote || behind.happened;
  if (old_bytes && !in_line_ && (new_bytes || came.ends_with('\n'))) {
    early_ = std::move(came);  // as if one host had written it
    return;
  }
  host_left(now);
  host_came(now);
  if (!new_bytes) return;
  early_ = std::move(came);
  skips_line_ = old_bytes;
}

// Kept apart from what the next host writes.
void PseudoTerminal::keep_what_is_left(sim::Clock now) {
  follow_speed(now);
  leaving_ = true;
  send_left_until_ = now + rate_.clocks(closing_seconds);
  left_ += std::exchange(early_, {}) + read_all();
}

void PseudoTerminal::send_what_is_left(sim::Clock now) {
  if (now >= send_left_until_) return host_left(now);
  if (held_back_ || now < rest_until_ || line_.waiting_bytes() >= line_buffer_bytes) return;
  send(now, std::string_view(left_).substr(0, line_buffer_bytes));
  left_.erase(0, line_buffer_bytes);
  if (line_.quiet() && now >= settled_at_) host_left(now);
}

void PseudoTerminal::host_came(sim::Clock now) {
  if (connected_) return;
  connected_ = true;
  if (on_open) on_open(now);
}

// The next host may have connected already, with a speed of its own.
void PseudoTerminal::host_left(sim::Clock now) {
  connected_ = leaving_ = throttled_ = unread_ = in_line_ = skips_line_ = false;
  early_.clear();
  left_.clear();
  to_host_.clear();
  // The next host finds neither the settings of this one nor bytes meant for it.
  if ((look() & POLLHUP) != 0) set_raw(master_, chip_baud_);
  const int slave = open(slave_path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave >= 0) {
    ioctl(slave, TIOCNXCL);
    tcflow(slave, TCOON);
    tcflush(slave, TCIFLUSH);
    close(slave);
  } else if (errno == EBUSY) {
    renew();
  }
  watch_->start_over((look() & POLLHUP) == 0);
  follow_speed(now);
  line_.hang_up(now, rate_.clocks(break_seconds));
  rest_until_ = now + rate_.clocks(break_seconds + rest_seconds);
  if (on_close) on_close(now);
}

void PseudoTerminal::follow_speed(sim::Clock now) {
  const std::uint32_t chosen = baud_of(master_);
  if (chosen == 0 || chosen == host_baud_) return;
  host_baud_ = chosen;
  line_.set_baud(now, chosen);
  // What was held back was written at the speed before.
  if (throttled_ || !early_.empty()) forget_unread();
}

void PseudoTerminal::forget_unread() {
  early_.clear();
  read_all();
}

}  // namespace devices
