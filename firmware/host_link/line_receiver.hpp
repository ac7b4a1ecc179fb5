// SPDX-License-Identifier: Apache-2.0
// Assembles bytes to lines and reads their framing: line number and checksum.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "host_link/line_number.hpp"
#include "units/text.hpp"

namespace host_link {

// With number and checksum, without line end. Marlin's is 96.
inline constexpr std::size_t max_line_length = units::longest_text;
// A letter and a digit, which its arguments follow.
inline constexpr std::size_t shortest_command = 2;

// Either ends a line, and so do both together.
inline constexpr char line_feed = '\n';
inline constexpr char carriage_return = '\r';

enum class Checksum : std::uint8_t { none, right, wrong };

struct ReceivedLine {
  std::string_view text;  // without number, checksum and blanks around; valid until the next put()
  bool starts_with_n{};
  std::optional<LineNumber> number{};
  Checksum checksum{};
  std::string_view behind_star{};  // of the last '*': the digits of a checksum, or something else
  bool too_long{};  // more than max_line_length: text is its beginning
  bool unprintable{};  // holds a byte outside 0x20 .. 0x7e that is no tab
  bool corrupted{};  // the uart saw an error in it
  bool torn{};  // after a line that was given up: it may be the rest of that
  std::uint32_t m_code{};  // of the M command that the text is; 0 where it is none
  std::string_view arguments{};  // what stands behind that code
  std::uint32_t fingerprint{};  // of the text, where it is framed
  // Number or checksum is there: the host keeps it for a resend.
  bool framed() const { return starts_with_n || checksum != Checksum::none; }
};

inline bool sets_numbering(const ReceivedLine& line) { return line.m_code == numbering_code; }
inline std::optional<LineNumber> number_set_by(const ReceivedLine& line) {
  return number_set_by(line.arguments);
}

class LineReceiver {
 public:
  struct Taken {
    std::size_t count;
    bool line_ended;  // by the last of them: the line is then to be taken
  };
  // Takes bytes up to the end of a line (\n, \r or \r\n). Empty lines are lines.
  Taken put(std::span<const char> bytes);
  // The incomplete line, which is then discarded.
  ReceivedLine take();

  // Discards the incomplete line; the next byte begins another.
  void forget() { clear(); }
  // The same, but the bytes up to the next line end may be its rest.
  void give_up();

  // The line in progress is broken, regardless of its checksum.
  void mark_corrupted() { corrupted_ = true; }

  bool unfinished() const { return length_ != 0; }
  // Whether it has a number or a checksum.
  bool unfinished_is_framed() const;

 private:
  void follow_checksum(unsigned char byte, std::uint32_t length, std::uint32_t exclusive_or);
  ReceivedLine read() const;
  void clear();

  std::array<char, max_line_length> buffer_{};
  std::uint32_t length_{};  // one more than the buffer holds where the line is longer
  // The checksum is that after the last '*', so a '*' in a text is allowed.
  std::uint32_t last_star_{};
  std::uint16_t checksum_value_{};
  std::uint8_t checksum_digits_{};
  bool checksum_malformed_{};
  std::uint8_t exclusive_or_{};
  std::uint8_t exclusive_or_before_star_{};
  bool star_seen_{};
  bool unprintable_{};
  bool corrupted_{};
  bool torn_{};
  bool after_carriage_return_{};
};

}  // namespace host_link
