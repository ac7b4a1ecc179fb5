// SPDX-License-Identifier: Apache-2.0
// Marker, header, payload, checksum.
#include "boot_loader/frame_receiver.hpp"

#include "boot_loader/checksum.hpp"

namespace boot_loader {

bool FrameReceiver::receive(std::uint8_t byte) {
  switch (state_) {
    case State::skipping:
      return false;
    case State::outside:
      if (byte == marker) {
        state_ = State::inside;
        count_ = 0;
      }
      return false;
    case State::inside:
      break;
  }
  buffer_[count_++] = byte;
  if (count_ < header_bytes) return false;
  if (payload_bytes() > most_payload_bytes) {
    state_ = State::skipping;
    return false;
  }
  return count_ == header_bytes + payload_bytes() + checksum_bytes && checked();
}

bool FrameReceiver::checked() {
  const std::size_t checked_bytes = header_bytes + payload_bytes();
  const bool right =
      checksum_of(std::span(buffer_).first(checked_bytes)) == word_at(buffer_, checked_bytes);
  state_ = right ? State::outside : State::skipping;
  return right;
}

bool FrameReceiver::silence() {
  const bool whole = state_ == State::outside;
  state_ = State::outside;
  return whole;
}

Frame FrameReceiver::frame() const {
  return {.kind = static_cast<Kind>(buffer_[0]),
          .payload = std::span(buffer_).subspan(header_bytes, payload_bytes())};
}

}  // namespace boot_loader
