// SPDX-License-Identifier: Apache-2.0
// Reads the kernel's notes on one terminal.
#include "sim/devices/terminal_watch.hpp"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace devices {

TerminalWatch::TerminalWatch(const std::string& terminal)
    : notes_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (notes_ < 0 ||
      inotify_add_watch(notes_, terminal.c_str(), IN_OPEN | IN_MODIFY | IN_CLOSE) < 0) {
    const int error = errno;
    if (notes_ >= 0) close(notes_);
    throw std::system_error(error, std::generic_category(), "cannot watch " + terminal);
  }
}

TerminalWatch::~TerminalWatch() { close(notes_); }

TerminalWatch::Change TerminalWatch::look() {
  Change change;
  bool wrote = false;
  alignas(inotify_event) std::array<char, 4096> buffer;
  for (ssize_t count = 1; count > 0;) {
    count = read(notes_, buffer.data(), buffer.size());
    for (ssize_t at = 0; at < count;) {
      inotify_event event;
      std::memcpy(&event, buffer.data() + at, sizeof(event));
      wrote = wrote || (event.mask & IN_MODIFY) != 0;
      note(event.mask, change);
      at += static_cast<ssize_t>(sizeof(event) + event.len);
    }
  }
  change.old_host_wrote = change.old_host_wrote || wrote_;
  wrote_ = change.happened ? change.new_host_wrote : wrote;
  return change;
}

void TerminalWatch::start_over(bool host_is_there) {
  look();
  open_ = host_is_there ? 1 : 0;
  closed_ = false;
}

// The kernel notes equal events that follow each other once.
void TerminalWatch::note(unsigned event, Change& change) {
  if ((event & IN_MODIFY) != 0) {
    (change.happened ? change.new_host_wrote : change.old_host_wrote) = true;
  }
  if ((event & IN_CLOSE) != 0 && open_ > 0) {
    --open_;
    closed_ = open_ == 0;
  }
  if ((event & IN_OPEN) == 0) return;
  ++open_;
  if (closed_) {
    // If several hosts came and went, those before the last one count as one.
    change.old_host_wrote = change.old_host_wrote || change.new_host_wrote;
    change.new_host_wrote = false;
    change.happened = true;
  }
  closed_ = false;
}

}  // namespace devices
