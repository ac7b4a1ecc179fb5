// SPDX-License-Identifier: Apache-2.0
// What a host program notices while it sends a file, told to the recorder and to the progress line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

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
  // `executed` is false where the chip said that it does not know or refuses the command.
  virtual void command_acknowledged([[maybe_unused]] sim::Clock now,
                                    [[maybe_unused]] std::size_t file_line,
                                    [[maybe_unused]] std::string_view command,
                                    [[maybe_unused]] bool executed) {}
  // Every line from the chip.
  virtual void reply([[maybe_unused]] sim::Clock now, [[maybe_unused]] std::string_view line) {}
};

}  // namespace devices
