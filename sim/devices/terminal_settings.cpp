// SPDX-License-Identifier: Apache-2.0
// Linux's own calls, because termios knows only the speeds of its list and 250000 baud is not among
// them. On a master they act on the slave.
#include "sim/devices/terminal_settings.hpp"

#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <system_error>

namespace devices {

void set_raw(int terminal, std::uint32_t baud) {
  termios2 settings{};
  if (ioctl(terminal, TCGETS2, &settings) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot read the terminal's settings");
  }
  settings.c_iflag = 0;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  settings.c_cflag = CS8 | CREAD | CLOCAL | BOTHER | BOTHER << IBSHIFT;
  settings.c_ispeed = settings.c_ospeed = baud;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (ioctl(terminal, TCSETS2, &settings) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot set the terminal");
  }
}

std::uint32_t baud_of(int terminal) {
  termios2 settings{};
  return ioctl(terminal, TCGETS2, &settings) == 0 ? settings.c_ospeed : 0;
}

}  // namespace devices
