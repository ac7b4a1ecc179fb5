// SPDX-License-Identifier: Apache-2.0
// The host's end of the boot loader's protocol (firmware/boot_loader), over any stream of bytes.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

#include "tools/loading/program.hpp"

namespace loading {

class ByteStream {
 public:
  ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;
  virtual ~ByteStream() = default;

  virtual void write(std::span<const std::uint8_t> bytes) = 0;
  // Waits so long for at least one byte; returns how many came, 0 after the time.
  virtual std::size_t read(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) = 0;
};

class LoadFailed : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Progress {
  // What is done now, a sentence each.
  std::function<void(const std::string&)> say = [](const std::string&) {};
  // After each block: bytes that the chip has.
  std::function<void(std::size_t)> sent = [](std::size_t) {};
};

struct Figures {
  unsigned repeated_frames{};  // because an answer was lost or reported damage
  unsigned restarts{};  // of the whole
};

// Brings the chip into its boot loader (M997, then knocking until it is reset), loads, has
// it checked and started. Throws LoadFailed; then what is in memory is not started.
Figures load(ByteStream& stream, const Program& program, const Progress& progress = {});

}  // namespace loading
