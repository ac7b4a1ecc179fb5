// SPDX-License-Identifier: Apache-2.0
// The chip's serial line on a pseudo-terminal, so that real host programs can open it as a port.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "sim/devices/serial_line.hpp"
#include "sim/devices/terminal_watch.hpp"
#include "tools/files/path_lock.hpp"

namespace devices {

// As with a USB serial adapter, hosts come and go: who comes finds a raw terminal at the chip's
// speed and nothing old in it; what is said while no host is there is lost; the wire runs at the
// speed that the host chooses, right or wrong. What a host has written goes out after it has closed
// the port, for 30 s at most as in Linux, unless the next one opens it before. Then the line is low
// for some time, so that the chip can give up a line that is not finished. A host that opens right
// after another one is known by what the kernel notes of both; only where both have written
// between two looks, half a millisecond apart, nothing says whose a byte is: a line that was begun
// before is then dropped, whole ones are taken as if one host had written them.
class PseudoTerminal : public sim::Device, public ByteListener {
 public:
  // The wire runs at `baud` until a host chooses otherwise. Throws std::system_error where no
  // pseudo-terminal can be made, and std::runtime_error where anything stands at `link` but the
  // symlink of a process of this user that was killed, or where that one is still served.
  PseudoTerminal(const std::filesystem::path& link, SerialLine& line, sim::ClockRate rate,
                 std::uint32_t baud);
  ~PseudoTerminal() override;

  // A host has opened the port (an adapter would raise DTR), or the last one has closed it.
  std::function<void(sim::Clock now)> on_open;
  std::function<void(sim::Clock now)> on_close;
  // Every byte of the chip, whether a host is connected or not.
  std::function<void(sim::Clock now, char byte)> on_byte;

  const std::string& slave_path() const { return slave_path_; }
  bool connected() const { return connected_; }

  // While the chip starts: no byte of the host goes out, all of them afterwards.
  void hold_back(bool held) { held_back_ = held; }
  // What the host has chosen, or the chip's own.
  std::uint32_t host_baud() const { return host_baud_; }
  // Sent by the chip while a host was connected, but not read by it.
  std::uint64_t bytes_dropped() const { return bytes_dropped_; }

  void wake(sim::Clock now) override;
  void byte_received(sim::Clock now, std::uint8_t byte) override;

 private:
  void make_slave();
  void make_link();
  void remove_link();
  void renew();
  void release();
  void note_traffic(sim::Clock now);
  short look() const;
  void take_from_host(sim::Clock now);
  std::string read_from_host();
  std::string read_all() const;
  void send(sim::Clock now, std::string_view bytes);
  void change_hosts(sim::Clock now, TerminalWatch::Change change, std::string came);
  void keep_what_is_left(sim::Clock now);
  void send_what_is_left(sim::Clock now);
  void host_came(sim::Clock now);
  void host_left(sim::Clock now);
  void follow_speed(sim::Clock now);
  void forget_unread();
  void flush();

  std::filesystem::path link_;
  std::string identity_;  // of the symlink that was made
  files::PathLock lock_;
  SerialLine& line_;
  sim::ClockRate rate_;
  sim::Clock poll_interval_;
  std::uint32_t chip_baud_;
  std::uint32_t host_baud_;
  int master_ = -1;
  std::string slave_path_;
  std::optional<TerminalWatch> watch_;
  bool connected_ = false;
  bool held_back_ = false;
  bool throttled_ = false;  // the host may have written more than was taken
  bool unread_ = false;  // something lay in the kernel at the last look
  bool in_line_ = false;  // the chip has the start of a line
  bool skips_line_ = false;  // up to its end: it may be a rest of the host before
  std::string early_;  // of the host, read before its turn
  bool leaving_ = false;  // the host has closed the port, and not all that it has written is sent
  std::string left_;  // that
  sim::Clock send_left_until_ = 0;
  sim::Clock rest_until_ = 0;  // of the line, after a host
  sim::Clock settled_at_ = 0;  // the line is idle for long enough since the last byte
  std::string to_host_;
  std::uint64_t bytes_dropped_ = 0;
};

}  // namespace devices
