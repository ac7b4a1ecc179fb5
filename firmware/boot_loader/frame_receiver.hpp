// SPDX-License-Identifier: Apache-2.0
// Finds frames among the bytes of the line.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "boot_loader/protocol.hpp"

namespace boot_loader {

struct Frame {
  Kind kind{};
  std::span<const std::uint8_t> payload;  // in the receiver, until its next byte
};

class FrameReceiver {
 public:
  // True where a frame is complete with this byte. After a damaged frame everything is skipped
  // until the line is idle, because the payload may look like a frame.
  bool receive(std::uint8_t byte);
  // The line was silent for a while. False where that was in a frame, or after a damaged one.
  bool silence();

  Frame frame() const;

 private:
  enum class State : std::uint8_t { outside, inside, skipping };

  std::size_t payload_bytes() const { return buffer_[1] | std::size_t{buffer_[2]} << 8; }
  bool checked();

  static constexpr std::size_t capacity = header_bytes + most_payload_bytes + checksum_bytes;
  std::array<std::uint8_t, capacity> buffer_{};
  std::size_t count_{};
  State state_{};
};

}  // namespace boot_loader
