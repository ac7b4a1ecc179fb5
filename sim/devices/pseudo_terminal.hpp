// SPDX-License-Identifier: Apache-2.0
// The chip's serial line on a pseudo-terminal, so that real host programs can open it as a port.
#pragma once

#include <filesystem>
#include <string>

#include "sim/devices/serial_line.hpp"

namespace devices {

// The slave is set raw before anybody opens it and one descriptor of it stays open, so that hosts
// may close and open it at any time. Throws std::system_error where no pseudo-terminal can be made,
// and std::runtime_error where `link` is there already and is no symlink.
class PseudoTerminal : public sim::Device, public ByteListener {
 public:
  PseudoTerminal(const std::filesystem::path& link, SerialLine& line, sim::ClockRate rate);
  ~PseudoTerminal() override;

  const std::string& slave_path() const { return slave_path_; }
  std::uint64_t bytes_dropped() const { return bytes_dropped_; }

  void wake(sim::Clock now) override;
  void byte_received(sim::Clock now, std::uint8_t byte) override;

 private:
  void flush();

  std::filesystem::path link_;
  SerialLine& line_;
  sim::Clock poll_interval_;
  int master_ = -1;
  int slave_ = -1;
  std::string slave_path_;
  std::string to_host_;
  std::uint64_t bytes_dropped_ = 0;
};

}  // namespace devices
