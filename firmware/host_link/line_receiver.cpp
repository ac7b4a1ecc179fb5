// SPDX-License-Identifier: Apache-2.0
// Reads the framing of a line.
#include "host_link/line_receiver.hpp"

#include "host_link/emergency.hpp"
#include "host_link/line_number.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

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

ReceivedLine LineReceiver::take() {
  units::happens<units::Event::line_taken>();
  const ReceivedLine line = read();
  clear();
  return line;
}

void LineReceiver::give_up() {
  clear();
  torn_ = true;
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
  if (line.framed()) line.fingerprint = fingerprint_of(text);
  line.arguments = text;
  line.m_code = take_m_code(line.arguments);
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
