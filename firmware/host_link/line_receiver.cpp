// SPDX-License-Identifier: Apache-2.0
// Line assembly. Checksum and its digits are followed byte by byte, so that even a line that is
// longer than the buffer is known to be whole or not.
#include "host_link/line_receiver.hpp"

#include <algorithm>
#include <limits>

#include "host_link/line_number.hpp"
#include "units/digits.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {
namespace {

using units::is_digit;
constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_text(char c) { return c == '\t' || (c >= ' ' && c <= '~'); }

// Noise that leaves the checksum intact mostly corrupts this.
constexpr bool may_follow_number(char c) {
  return is_blank(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == ';' || c == '(';
}

void trim(std::string_view& text) {
  units::LoopBound<max_line_length> front;
  while (!text.empty() && is_blank(text.front())) {
    front.next();
    text.remove_prefix(1);
    units::happens<units::Event::character_read>(text.size());
  }
  units::LoopBound<max_line_length, 1> back;
  while (!text.empty() && is_blank(text.back())) {
    back.next();
    text.remove_suffix(1);
    units::happens<units::Event::character_read>(text.size());
  }
}

}  // namespace

bool LineReceiver::put(char byte) {
  if (byte != line_feed && byte != carriage_return) {
    after_carriage_return_ = false;
    put_into_line(byte);
    return false;
  }
  const bool line_feed_of_pair = byte == line_feed && after_carriage_return_;
  after_carriage_return_ = byte == carriage_return;
  return !line_feed_of_pair;
}

ReceivedLine LineReceiver::take() {
  const ReceivedLine line = read();
  clear();
  return line;
}

void LineReceiver::give_up() {
  clear();
  torn_ = true;
}

void LineReceiver::put_into_line(char byte) {
  if (length_ < max_line_length) buffer_[length_] = byte;
  if (byte == '*') {
    star_seen_ = true;
    last_star_ = length_;
    exclusive_or_before_star_ = exclusive_or_;
    checksum_value_ = 0;
    checksum_digits_ = 0;
    checksum_malformed_ = false;
  } else if (star_seen_) {
    put_into_checksum(byte);
  }
  exclusive_or_ = static_cast<std::uint8_t>(exclusive_or_ ^ static_cast<std::uint8_t>(byte));
  if (!is_text(byte)) unprintable_ = true;
  if (length_ < std::numeric_limits<std::uint32_t>::max()) ++length_;
}

void LineReceiver::put_into_checksum(char byte) {
  if (is_digit(byte) && checksum_digits_ < 3 && !checksum_malformed_) {
    checksum_value_ = static_cast<std::uint16_t>(checksum_value_ * 10 + (byte - '0'));
    ++checksum_digits_;
  } else if (is_blank(byte) && checksum_digits_ > 0) {
    checksum_digits_ = 3;  // blanks may follow, digits no more
  } else {
    checksum_malformed_ = true;
  }
}

ReceivedLine LineReceiver::read() const {
  units::EventBound<units::Event::character_read, max_line_length> trimmed;
  ReceivedLine line;
  line.too_long = length_ > max_line_length;
  line.unprintable = unprintable_;
  line.corrupted = corrupted_;
  line.torn = torn_;
  std::string_view text(buffer_.data(), line.too_long ? max_line_length : length_);
  if (star_seen_) {
    const bool right = checksum_digits_ > 0 && !checksum_malformed_ &&
                       checksum_value_ == exclusive_or_before_star_;
    line.checksum = right ? Checksum::right : Checksum::wrong;
    if (last_star_ < text.size()) {
      line.behind_star = text;
      line.behind_star.remove_prefix(last_star_ + 1);
      text.remove_suffix(text.size() - last_star_);
    }
  }
  trim(text);
  if (!text.empty() && text.front() == 'N') {
    line.starts_with_n = true;
    text.remove_prefix(1);
    line.number = take_line_number(text);
    if (!text.empty() && !may_follow_number(text.front())) line.number = std::nullopt;
    trim(text);
  }
  line.text = text;
  return line;
}

bool LineReceiver::unfinished_is_framed() const {
  return star_seen_ || (length_ > 0 && buffer_[0] == 'N');
}

void LineReceiver::clear() {
  length_ = 0;
  exclusive_or_ = 0;
  star_seen_ = false;
  checksum_malformed_ = false;
  unprintable_ = false;
  corrupted_ = false;
  torn_ = false;
}

}  // namespace host_link
