// SPDX-License-Identifier: Apache-2.0
// The line parser: one pass over the bytes, each looked at once or twice.
#include "gcode/parser.hpp"

#include "gcode/number.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace gcode {
namespace {

using units::longest_text;

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
// Independent of whether char is signed, which differs between the host and the target.
constexpr bool is_printable(char c) { return c >= ' ' && c <= '~'; }
constexpr bool is_control(char c) {
  return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == 0x7f;
}
constexpr char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr bool is_letter(char c) { return capital(c) >= 'A' && capital(c) <= 'Z'; }

// The rest of the line is a name or a message, and is not parsed.
bool takes_text(const Command& command) {
  if (command.letter != 'M') return false;
  switch (command.code) {
    case 23:  // select a file
    case 28:  // write a file
    case 29:  // end of that
    case 30:  // delete a file
    case 32:  // print a file
    case 33:  // long name of a file
    case 117:  // show a message
    case 118:  // send a message to the host
    case 486:  // name an object
    case 928:  // log to a file
      return true;
    default:
      return false;
  }
}

// Parameters first, and a message from the first word without a number on: M0 S5
// Change the filament
bool may_end_in_text(const Command& command) { return command.is('M', 0) || command.is('M', 1); }

class LineParser {
 public:
  LineParser(std::string_view line, Command& command) : line_(line), command_(command) {}

  std::optional<ParseError> parse() {
    // It goes back once, in M0 and M1, to a text; those in quotes are looked at once more.
    units::EventBound<units::Event::character_read, longest_text> places;
    units::EventBound<units::Event::text_checked, longest_text> texts;
    units::EventBound<units::Event::comment_skipped, longest_text / 2> comments;
    if (!skip_blanks_and_comments()) return failure();
    if (at_end()) return fail(ParseFault::empty_line, position_);
    if (!read_name_of_objects() && !read_letter_and_code()) return failure();
    skip_blanks();
    if (command_.is('G', 53) && !skip_blanks_and_comments()) return failure();
    if (command_.is('G', 53) && !at_end() && capital(here()) == 'G') {
      command_.clear();
      command_.in_machine_coordinates = true;
      const std::size_t start = position_;
      if (!read_letter_and_code()) return failure();
      constexpr std::uint16_t last_move = 3;  // G0 to G3
      if (command_.code > last_move) return fail(ParseFault::second_command, start);
      skip_blanks();
    }
    if (takes_text(command_)) {
      if (!read_text()) return failure();
      return std::nullopt;
    }
    // Each letter once; what follows the last of them ends the line or is refused.
    constexpr std::uint32_t letters = 'Z' - 'A' + 1;
    units::LoopBound<letters + 1> parameters;
    for (;;) {
      if (!skip_blanks_and_comments()) return failure();
      parameters.next();
      if (at_end()) return std::nullopt;
      if (!read_parameter()) return failure();
    }
  }

 private:
  bool at_end() const { return position_ >= line_.size(); }
  char here() const { return line_[position_]; }
  // Not substr(), which can throw.
  std::string_view part(std::size_t start, std::size_t end) const {
    return {line_.data() + start, end - start};
  }
  bool at_digit() const { return !at_end() && is_digit(here()); }

  // Remembers the error; false, so that a caller can return it at once.
  [[gnu::cold]] bool set_error(ParseFault fault, std::size_t position) {
    error_ = {fault, static_cast<std::uint32_t>(position)};
    return false;
  }
  std::optional<ParseError> failure() const { return error_; }
  std::optional<ParseError> fail(ParseFault fault, std::size_t position) {
    set_error(fault, position);
    return failure();
  }

  void skip_blanks() {
    units::LoopBound<longest_text> blanks;
    while (!at_end() && is_blank(here())) {
      blanks.next();
      ++position_;
      units::happens<units::Event::character_read>(position_);
    }
  }

  // To behind the next of these characters, if there is one; otherwise to the end.
  bool skip_behind(char last) {
    units::LoopBound<longest_text, 1> characters;
    while (!at_end()) {
      characters.next();
      const bool found = here() == last;
      ++position_;
      units::happens<units::Event::character_read>(position_);
      if (found) return true;
    }
    return false;
  }

  bool skip_blanks_and_comments() {
    // Two brackets each, and the round behind the last of them.
    units::LoopBound<longest_text / 2 + 1> comments;
    for (;;) {
      comments.next();
      skip_blanks();
      if (at_end()) return true;
      if (here() == ';') {
        position_ = line_.size();
        return true;
      }
      if (here() != '(') {
        return true;
      }
      const std::size_t opening = position_;
      if (!skip_behind(')')) {
        return set_error(ParseFault::unclosed_comment, opening);
      }
      units::happens<units::Event::comment_skipped>();
    }
  }

  // What slicers write for Klipper to know the parts of a print counts as Marlin's M486:
  // EXCLUDE_OBJECT_START NAME=part, of which "_START NAME=part" is its text.
  bool read_name_of_objects() {
    constexpr std::string_view name = "EXCLUDE_OBJECT";
    if (line_.size() - position_ < name.size()) return false;
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (capital(line_[position_ + i]) != name[i]) return false;
    }
    position_ += name.size();
    command_.letter = 'M';
    command_.code = 486;
    return true;
  }

  bool read_letter_and_code() {
    const char letter = capital(here());
    if (!is_printable(here())) return set_error(ParseFault::unprintable_byte, position_);
    if (letter != 'G' && letter != 'M' && letter != 'T') {
      return set_error(ParseFault::unknown_letter, position_);
    }
    command_.letter = letter;
    ++position_;
    skip_blanks();
    if (!at_digit()) return set_error(ParseFault::missing_code, position_);
    std::uint32_t code = 0;
    if (!read_integer(code, 0xffff)) return set_error(ParseFault::code_overflow, position_);
    command_.code = static_cast<std::uint16_t>(code);
    if (!at_end() && here() == '.') {
      ++position_;
      std::uint32_t subcode = 0;
      if (!at_digit() || !read_integer(subcode, 0xff)) {
        return set_error(ParseFault::malformed_code, position_);
      }
      command_.subcode = static_cast<std::uint8_t>(subcode);
    }
    if (!at_end() && starts_number(here())) return set_error(ParseFault::malformed_code, position_);
    return true;
  }

  bool read_integer(std::uint32_t& value, std::uint32_t largest) {
    units::LoopBound<longest_text> digits;
    while (at_digit()) {
      digits.next();
      value = value * 10 + static_cast<std::uint32_t>(here() - '0');
      if (value > largest) return false;
      ++position_;
      units::happens<units::Event::character_read>(position_);
    }
    return true;
  }

  // To the end or to a comment; '*' and '(' belong to the text, as they do for Marlin.
  [[gnu::cold]] bool read_text() {
    const std::size_t start = position_;
    std::size_t end = position_;
    units::LoopBound<longest_text> characters;
    while (!at_end() && here() != ';') {
      characters.next();
      const char c = here();
      if (is_control(c)) return set_error(ParseFault::unprintable_byte, position_);
      ++position_;
      units::happens<units::Event::text_checked>(position_);
      if (!is_blank(c)) end = position_;
    }
    command_.text = part(start, end);
    return true;
  }
  [[gnu::cold]] bool read_quoted_text() {
    const std::size_t quote = position_++;
    if (!skip_behind('"')) return set_error(ParseFault::unclosed_quote, quote);
    const std::size_t closing = position_ - 1;
    command_.text = part(quote + 1, closing);
    units::LoopBound<longest_text> characters;
    for (std::size_t i = quote + 1; i < closing; ++i) {
      characters.next();
      const char c = line_[i];
      units::happens<units::Event::text_checked>(static_cast<unsigned char>(c));
      if (is_control(c)) return set_error(ParseFault::unprintable_byte, i);
    }
    return true;
  }

  bool read_parameter() {
    const std::size_t start = position_;
    const char letter = capital(here());
    if (!is_letter(here())) {
      if (may_end_in_text(command_)) return read_text();
      return set_error(
          is_printable(here()) ? ParseFault::unexpected_character : ParseFault::unprintable_byte,
          start);
    }
    ++position_;
    skip_blanks();
    const bool numeric = !at_end() && starts_number(here());
    if (may_end_in_text(command_) && !numeric) {
      position_ = start;
      return read_text();
    }
    if (letter == 'G' || letter == 'M') return set_error(ParseFault::second_command, start);
    if (command_.has(letter)) return set_error(ParseFault::duplicate_letter, start);
    if (numeric) {
      const std::expected<Number, ParseError> number = read_number(line_, position_);
      if (!number) return set_error(number.error().fault, number.error().position);
      command_.set(letter, *number);
      return true;
    }
    command_.set_flag(letter);
    return at_end() || here() != '"' || read_quoted_text();
  }

  std::string_view line_;
  std::size_t position_{};
  Command& command_;
  ParseError error_{};
};

}  // namespace

std::optional<ParseError> parse(std::string_view line, Command& command) {
  command.clear();
  return LineParser(line, command).parse();
}

std::expected<Command, ParseError> parse(std::string_view line) {
  std::expected<Command, ParseError> result;
  if (const auto error = parse(line, *result)) result = std::unexpected(*error);
  return result;
}

}  // namespace gcode
