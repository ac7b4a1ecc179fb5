// SPDX-License-Identifier: Apache-2.0
// The loop over the bytes of a line, apart from the rest because it is compiled for speed. Checksum
// and its digits are followed byte by byte, so that even a line that is longer than the buffer is
// known to be whole or not.
#include "host_link/host_link.hpp"
#include "host_link/line_receiver.hpp"
#include "units/digits.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {
namespace {

constexpr bool is_mere_text(unsigned char c) { return unsigned{c} - ' ' <= '~' - ' ' && c != '*'; }

}  // namespace

[[gnu::noinline]] LineReceiver::Taken LineReceiver::put(std::span<const char> bytes) {
  const char* here = bytes.data();
  const char* const end = here + bytes.size();
  std::uint32_t length = length_, exclusive_or = exclusive_or_;
  bool star_seen = star_seen_, after_carriage_return = after_carriage_return_;
  bool line_ended = false;
  units::LoopBound<HostLink::most_bytes> characters;
  while (here != end) {
    characters.next();
    const auto byte = static_cast<unsigned char>(*here++);
    units::happens<units::Event::byte_taken>(reinterpret_cast<std::uintptr_t>(here));
    if (!is_mere_text(byte)) {
      if (byte == carriage_return || (byte == line_feed && !after_carriage_return)) {
        after_carriage_return = byte == carriage_return;
        line_ended = true;
        break;
      }
      if (byte == line_feed) {
        after_carriage_return = false;
        continue;
      }
      if (byte == '*') {
        star_seen = true;
      } else if (byte != '\t') {
        unprintable_ = true;
      }
    }
    after_carriage_return = false;
    if (star_seen) follow_checksum(byte, length, exclusive_or);
    if (length < max_line_length) buffer_[length] = static_cast<char>(byte);
    if (length <= max_line_length) ++length;
    exclusive_or ^= byte;
  }
  length_ = length;
  exclusive_or_ = static_cast<std::uint8_t>(exclusive_or);
  star_seen_ = star_seen;
  after_carriage_return_ = after_carriage_return;
  return {static_cast<std::size_t>(here - bytes.data()), line_ended};
}

// From a star on, which comes after so many bytes, of which this is the exclusive or.
[[gnu::noinline]] void LineReceiver::follow_checksum(unsigned char byte, std::uint32_t length,
                                                     std::uint32_t exclusive_or) {
  const bool is_digit = units::is_digit(static_cast<char>(byte));
  if (byte == '*') {
    last_star_ = length;
    exclusive_or_before_star_ = static_cast<std::uint8_t>(exclusive_or);
    checksum_value_ = 0;
    checksum_digits_ = 0;
    checksum_malformed_ = false;
  } else if (is_digit && checksum_digits_ < 3 && !checksum_malformed_) {
    checksum_value_ = static_cast<std::uint16_t>(checksum_value_ * 10 + (byte - '0'));
    ++checksum_digits_;
  } else if ((byte == ' ' || byte == '\t') && checksum_digits_ > 0) {
    checksum_digits_ = 3;  // blanks may follow, digits no more
  } else {
    checksum_malformed_ = true;
  }
}

}  // namespace host_link
