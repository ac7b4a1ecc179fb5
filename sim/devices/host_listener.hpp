// SPDX-License-Identifier: Apache-2.0
// Interfaces of hosts that send commands to the chip, and of listeners to them, such as
// the recorder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/simulation/pins.hpp"

namespace devices {

class HostListener {
 public:
  HostListener() = default;
  HostListener(const HostListener&) = delete;
  HostListener& operator=(const HostListener&) = delete;
  virtual ~HostListener() = default;

  // `file_line` counts from 1; 0 stands for a command that the host adds itself.
  virtual void command_sent([[maybe_unused]] sim::Clock now, [[maybe_unused]] std::size_t file_line,
                            [[maybe_unused]] std::string_view command) {}
  // `executed` is false if the chip answered that it does not know or refuses the command.
  virtual void command_acknowledged([[maybe_unused]] sim::Clock now,
                                    [[maybe_unused]] std::size_t file_line,
                                    [[maybe_unused]] std::string_view command,
                                    [[maybe_unused]] bool executed) {}
  // Every line from the chip.
  virtual void reply([[maybe_unused]] sim::Clock now, [[maybe_unused]] std::string_view line) {}
};

struct HostCounts {
  std::uint64_t lines_sent{};  // on the wire, resends included
  std::uint64_t resends{};
  std::uint64_t lines_executed{};  // that the chip answered well, the host's own included
  std::uint64_t commands_executed{};  // that the chip carried out
  std::uint64_t commands_refused{};  // that the chip did not know or refused
  std::uint64_t busy_replies{};
};

// Whatever is at the other end of the serial line, as far as its commands can be observed.
class Host {
 public:
  Host() = default;
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  virtual ~Host() = default;

  void add_listener(HostListener& listener) { listeners_.push_back(&listener); }
  const HostCounts& counts() const { return counts_; }

 protected:
  std::vector<HostListener*> listeners_;
  HostCounts counts_;
};

}  // namespace devices
