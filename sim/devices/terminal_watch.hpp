// SPDX-License-Identifier: Apache-2.0
// Who has opened, written to and closed a terminal since the last look, in their order.
#pragma once

#include <cstddef>
#include <string>

namespace devices {

// What the kernel notes at each opening, write and closing (inotify): nothing of it is missed,
// however short it was. How many bytes a write had is not noted.
class TerminalWatch {
 public:
  // From now on. Throws std::system_error where the kernel gives no such notes.
  explicit TerminalWatch(const std::string& terminal);
  TerminalWatch(const TerminalWatch&) = delete;
  TerminalWatch& operator=(const TerminalWatch&) = delete;
  ~TerminalWatch();

  // The last host has closed the terminal, and another one has opened it.
  struct Change {
    bool happened = false;
    bool old_host_wrote = false;  // since the look before the last: it may not have been read yet
    bool new_host_wrote = false;
  };
  // Since the last look. A host that opens while another one is there is no change.
  Change look();
  // Whatever was until now does not count; whether a host has the terminal open.
  void start_over(bool host_is_there);

 private:
  void note(unsigned event, Change& change);

  int notes_ = -1;
  std::size_t open_ = 0;  // so many have it open
  bool wrote_ = false;  // the host that is there, between the last two looks
  bool closed_ = false;  // by the last of them, and not opened since
};

}  // namespace devices
