// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/breeder.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "application/gcode_table.hpp"

namespace worst_inputs {

namespace {

constexpr std::size_t most_lines = 3, most_pieces = 4;
constexpr std::uint32_t longest_pause_us = 5'000;
constexpr std::string_view digits = "0123456789";

// Borders of ranges and of numbers, and what is none.
constexpr std::array<std::string_view, 24> borders{
    "0",     "1",    "-1",    "0.5",  "-0.001",     "0.0001",      "60",          "200",
    "255",   "1000", "12000", "9999", "2147483647", "-2147483648", "4294967295",  "99999999999",
    "86400", "1e5",  ".",     "-",    "+3",         "-.5",         "0000000.001", ""};

// What ends a number, a word or a line, and what may not be in one.
constexpr std::string_view bytes_of_interest{" \t;()*NGMTXYZE.-+0123456789\r\n\"\\\x00\x1b\x7f\xff",
                                             42};

// From the line that holds a place.
std::pair<std::size_t, std::size_t> line_at(const std::string& bytes, std::size_t place) {
  const std::size_t before = place == 0 ? std::string::npos : bytes.rfind('\n', place - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t end = bytes.find('\n', place);
  return {begin, end == std::string::npos ? bytes.size() : end + 1};
}

// At the end of a line, where there is one.
void cut(SerialInput& input) {
  std::size_t left = most_bytes;
  for (Piece& piece : input) {
    if (piece.bytes.size() > left) {
      const std::size_t end = left == 0 ? std::string::npos : piece.bytes.rfind('\n', left - 1);
      piece.bytes.resize(end == std::string::npos ? left : end + 1);
      left = piece.bytes.size();
    }
    left -= piece.bytes.size();
  }
  std::erase_if(input, [](const Piece& piece) { return piece.bytes.empty(); });
  if (input.empty()) input.push_back({.pause_us = 0, .bytes = "\n"});
}

}  // namespace

std::size_t Breeder::below(std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
}

std::string Breeder::state() const {
  std::ostringstream text;
  text << random_;
  return text.str();
}

void Breeder::resume(const std::string& state) {
  std::istringstream text(state);
  if (!(text >> random_)) throw std::runtime_error("it has no state of the random numbers");
}

std::string Breeder::long_number() {
  std::string text(one_in(2) ? "-" : "");
  for (std::size_t left = 1 + below(10); left != 0; --left) text += digits[below(digits.size())];
  if (one_in(4)) return text;
  text += '.';
  for (std::size_t left = below(12); left != 0; --left) text += digits[below(digits.size())];
  return text;
}

std::string Breeder::number() {
  if (one_in(3)) return std::string(borders[below(borders.size())]);
  if (one_in(2)) return long_number();
  return std::to_string(static_cast<double>(below(400'000)) / 1'000 - 200);
}

// Moves often, since most commands take little time on a printer that does not move.
std::string Breeder::line() {
  const auto& table = application::gcode_table;
  const application::GcodeRow& row = table[one_in(3) ? below(4) : below(table.size())];
  std::string text(1, row.letter);
  text += std::to_string(row.code);
  const std::size_t share = 1 + below(4);  // of its letters
  for (const application::Argument& argument : row.arguments) {
    if (argument.letters.empty()) {
      text += ' ';
      text.append(below(100), static_cast<char>('a' + below(26)));
    }
    for (const char letter : argument.letters) {
      if (below(4) >= share) continue;
      if (one_in(2)) text += ' ';
      text += letter;
      text += number();
    }
  }
  if (one_in(8)) text += "(a comment) ;" + long_number();
  if (one_in(8)) text.insert(0, "N" + number() + " ");
  if (one_in(8)) text += "*" + std::to_string(below(300));
  return text + '\n';
}

SerialInput Breeder::random() {
  SerialInput input(1);
  for (std::size_t lines = 1 + below(most_lines); lines != 0; --lines) {
    if (one_in(4) && input.size() < most_pieces) {
      input.push_back({.pause_us = static_cast<std::uint32_t>(below(longest_pause_us)),
                       .bytes = {},
                       .waits = one_in(2)});
    }
    input.back().bytes += line();
  }
  cut(input);
  return input;
}

void Breeder::change_number(std::string& bytes) {
  const std::size_t from = bytes.find_first_of(digits, below(bytes.size()));
  if (from == std::string::npos) return;
  const std::size_t end = std::min(bytes.find_first_not_of("0123456789.", from), bytes.size());
  if (one_in(2)) {
    bytes.replace(from, end - from, number());
  } else {
    bytes[from + below(end - from)] = digits[below(digits.size())];
  }
}

void Breeder::change_line(std::string& bytes) {
  const auto [begin, end] = line_at(bytes, below(bytes.size()));
  const std::string old = bytes.substr(begin, end - begin);
  switch (below(5)) {
    case 0:
      bytes.replace(begin, end - begin, line());
      break;
    case 1:
      bytes.insert(begin, line());
      break;
    case 2:
      bytes.erase(begin, end - begin);
      break;
    case 3:
      bytes.insert(begin, old);
      break;
    default: {
      // One more letter with a number before the line's end.
      std::string word(1, static_cast<char>('A' + below(26)));
      word += number();
      bytes.insert(old.ends_with('\n') ? end - 1 : end, word);
    }
  }
}

void Breeder::change_byte(std::string& bytes) {
  const std::size_t place = below(bytes.size());
  const char byte = bytes_of_interest[below(bytes_of_interest.size())];
  switch (below(4)) {
    case 0:
      bytes[place] = byte;
      break;
    case 1:
      bytes.insert(place, 1 + below(12), byte);
      break;
    case 2:
      bytes.erase(place, 1 + below(6));
      break;
    default:
      bytes.insert(place, bytes.substr(place, below(40)));
  }
}

void Breeder::split(SerialInput& input, std::size_t piece) {
  const auto pause = static_cast<std::uint32_t>(below(longest_pause_us));
  if (input.size() == most_pieces || one_in(3)) {
    input[piece].pause_us = one_in(3) ? 0 : pause;
    input[piece].waits = one_in(2);
    return;
  }
  const std::size_t place = below(input[piece].bytes.size());
  Piece behind{.pause_us = pause, .bytes = input[piece].bytes.substr(place), .waits = one_in(2)};
  input[piece].bytes.resize(place);
  input.insert(input.begin() + static_cast<std::ptrdiff_t>(piece) + 1, std::move(behind));
}

void Breeder::change(SerialInput& input) {
  const std::size_t piece = below(input.size());
  std::string& bytes = input[piece].bytes;
  switch (below(8)) {
    case 0:
    case 1:
    case 2:
      change_number(bytes);
      break;
    case 3:
    case 4:
      change_line(bytes);
      break;
    case 5:
    case 6:
      change_byte(bytes);
      break;
    default:
      split(input, piece);
  }
  cut(input);
}

SerialInput Breeder::changed(SerialInput input) {
  const SerialInput parent = input;
  constexpr int tries = 8;
  for (int i = 0; i < tries && input == parent; ++i) {
    for (std::size_t times = 1 + below(4); times != 0; --times) change(input);
  }
  return input;
}

SerialInput Breeder::crossed(const SerialInput& one, const SerialInput& other) {
  SerialInput child(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(1 + below(one.size())));
  child.insert(child.end(), other.begin() + static_cast<std::ptrdiff_t>(below(other.size())),
               other.end());
  if (child.size() > most_pieces) child.resize(most_pieces);
  cut(child);
  return child;
}

}  // namespace worst_inputs
