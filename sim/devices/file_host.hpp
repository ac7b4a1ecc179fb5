// SPDX-License-Identifier: Apache-2.0
// A host program that prints a G-code file: line numbers and checksums, one line in flight,
// resends.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/devices/gcode_file.hpp"
#include "sim/devices/host_listener.hpp"
#include "sim/devices/serial_line.hpp"

namespace devices {

enum class HostState : std::uint8_t { waiting_for_start, printing, completed, faulted };

// The dialogue is that of Marlin's hosts: `N<number> <command>*<checksum>`, then `ok`; `Resend: N`
// names the line to send again after the next `ok`. `echo:` lines are remarks; `Error:` lines
// announce a resend or are fatal. After the file comes M400, so that `completed` means that the
// last move has been made.
class FileHost : public sim::Device, public ByteListener, public Host {
 public:
  FileHost(std::vector<FileCommand> commands, SerialLine& line, sim::ClockRate rate);

  HostState state() const { return state_; }
  bool ended() const { return state_ == HostState::completed || state_ == HostState::faulted; }
  // Why the print has faulted: one sentence, with the line of the file.
  const std::string& fault() const { return fault_; }
  // Commands of the file that are done, and all of them.
  std::size_t done() const { return acknowledged_; }
  std::size_t total() const { return script_.size(); }

  void wake(sim::Clock now) override;
  void byte_received(sim::Clock now, std::uint8_t byte) override;

 private:
  void take_reply(sim::Clock now, const std::string& reply);
  void acknowledge(sim::Clock now);
  void ask_again(sim::Clock now, const std::string& reply);
  void take_error(sim::Clock now, const std::string& reply);
  void send_line(sim::Clock now);
  void fail(std::string reason);
  std::string place() const;
  void watch(sim::Clock now);

  std::vector<FileCommand> script_;  // index = line number; 0 is M110
  SerialLine& line_;
  sim::ClockRate rate_;
  HostState state_ = HostState::waiting_for_start;
  std::string fault_;
  std::string reply_;
  std::size_t next_ = 0;  // line to send next
  std::size_t acknowledged_ = 0;  // lines before this one are done
  bool in_flight_ = false;
  bool resend_asked_ = false;
  bool refused_ = false;  // the chip has spoken against the line in flight
  unsigned resends_of_line_ = 0;
  std::string last_error_;
  sim::Clock silent_since_ = 0;
  sim::Clock resend_asked_at_ = 0;
};

}  // namespace devices
