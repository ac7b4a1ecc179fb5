// SPDX-License-Identifier: Apache-2.0
// A host program that prints a G-code file: line numbers and checksums, lines in flight, resends.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/devices/gcode_file.hpp"
#include "sim/devices/host_listener.hpp"
#include "sim/devices/serial_line.hpp"

namespace devices {

enum class HostState : std::uint8_t { waiting_for_start, printing, completed, faulted };

struct HostOptions {
  // Lines sent and not answered yet. Printrun and OctoPrint wait for the ok of each line; Cura
  // keeps 4 in flight.
  std::size_t window = 1;
  // M0 and M1 are answered with M108, as by a user who presses Continue at once.
  bool answers_prompts = true;
  // Called with notes for the user: one sentence each, with the line of the file.
  std::function<void(const std::string& note)> note = [](const std::string&) {};
};

// The dialogue is that of Marlin's hosts: `N<number> <command>*<checksum>`, then `ok`; `Resend: N`
// names the line to send again after the next `ok`. `echo:` lines are remarks; `Error:` lines
// announce a resend or are fatal. M110 of the file is left out, since the numbers are the host's.
// After the file comes M400, so that `completed` means that the last move has been made; more of
// them where the chip may have answered copies of lines.
class FileHost : public sim::Device, public ByteListener, public Host {
 public:
  FileHost(std::vector<FileCommand> commands, SerialLine& line, sim::ClockRate rate,
           HostOptions options = {});

  HostState state() const { return state_; }
  bool ended() const { return state_ == HostState::completed || state_ == HostState::faulted; }
  // Why the print has failed: one sentence, with the line of the file.
  const std::string& fault() const { return fault_; }
  // Commands of the file, without those that are not sent.
  std::size_t commands() const { return script_.size() - own_lines_; }
  // Lines that are done, and all of them, with the host's own.
  std::size_t done() const { return acknowledged_; }
  std::size_t total() const { return script_.size(); }

  void wake(sim::Clock now) override;
  void byte_received(sim::Clock now, std::uint8_t byte) override;

 private:
  // A line that has no answer yet; nothing for one outside the numbering.
  using Flight = std::optional<std::size_t>;

  void take_reply(sim::Clock now, const std::string& reply);
  void take_action(sim::Clock now, std::string_view action);
  void acknowledge(sim::Clock now);
  void acknowledge_line(sim::Clock now, std::size_t index);
  void ask_again(sim::Clock now, const std::string& reply);
  bool requested_too_often(std::size_t number);
  void take_error(sim::Clock now, const std::string& reply);
  void answer_prompt(sim::Clock now);
  void send_lines(sim::Clock now);
  void send_line(sim::Clock now, std::size_t index);
  void fail(std::string reason);
  const FileCommand& present() const;
  std::string place() const;
  void watch();

  std::vector<FileCommand> script_;  // index = line number; 0 is M110
  SerialLine& line_;
  sim::ClockRate rate_;
  HostOptions options_;
  HostState state_ = HostState::waiting_for_start;
  std::string fault_;
  std::string reply_;
  std::size_t next_ = 0;  // line to send next
  std::size_t announced_ = 0;  // lines before this one have been sent once
  std::size_t acknowledged_ = 0;  // lines before this one are done
  std::deque<Flight> in_flight_;  // in the order in which they will be answered
  std::size_t own_lines_ = 2;  // of the script: M110 and M400
  // Lines that were sent twice and may be answered twice. For each an M400 more follows the script:
  // the ok to a copy is then not taken for that of the last line.
  std::size_t oks_in_doubt_ = 0;
  bool resend_asked_ = false;
  bool refused_ = false;  // the chip has spoken against the first line in flight
  bool prompt_answered_ = false;
  // Since the last line that was done for the first time.
  std::optional<std::size_t> resend_number_;
  unsigned resends_of_line_ = 0;
  unsigned resends_without_progress_ = 0;
  std::string last_error_;
  sim::Clock silent_since_ = 0;
  sim::Clock resend_asked_at_ = 0;
};

}  // namespace devices
