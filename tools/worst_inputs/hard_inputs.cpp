// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/hard_inputs.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "units/text.hpp"

namespace worst_inputs {

namespace {

// With the number that M110 has set before, and its checksum.
std::string numbered(unsigned number, std::string_view text) {
  const std::string line = fmt::format("N{} {}", number, text);
  unsigned checksum = 0;
  for (const char byte : line) checksum ^= static_cast<unsigned char>(byte);
  return fmt::format("{}*{}\n", line, checksum);
}

// As long as a line may be, by blanks in front of it or by digits behind.
std::string lengthened(std::string_view text, char with, bool in_front) {
  std::string line(text);
  const std::size_t missing = units::longest_text - 1 - line.size();
  line.insert(in_front ? 0 : line.size(), missing, with);
  return line + '\n';
}

SerialInput at_once(std::string bytes) { return {{.pause_us = 0, .bytes = std::move(bytes)}}; }

// Each letter with a fraction, and from the last word without a number on a text, for which the
// parser goes back.
std::string many_words() {
  std::string line("M0 ");
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (std::string_view("GMNT").find(letter) == std::string_view::npos) {
      line += fmt::format("{}.1", letter);
    }
  }
  return lengthened(line, 'a', false);
}

}  // namespace

std::vector<SerialInput> hard_inputs() {
  constexpr std::string_view move =
      "G1 X123.4567891234 Y-87.6543219876 Z12.3456789123 E1234.56789123 F7654.32198765";
  constexpr std::string_view beyond =
      "G1 X99999999.999999 Y-99999999.999999 Z88888888.888888 E1 F1";
  // From (100, 100): almost a circle, which leaves the bed.
  constexpr std::string_view arc_beyond =
      "G2 X100.00012345 Y99.999912345 Z12.345678912 E0.12345678 I123.00012345 J0.00012345 "
      "F7654.32198765\n";
  std::string arcs_beyond;
  for (int i = 0; i < 3; ++i) arcs_beyond += arc_beyond;
  std::vector<SerialInput> inputs{
      at_once(lengthened(move, '0', false)),
      at_once(lengthened(move, ' ', true)),
      at_once(lengthened(beyond, '9', false)),
      at_once(lengthened("G1 X1(", ')', false)),
      at_once(lengthened("M118 ", '~', false)),
      at_once(lengthened("Q1 ", '\x7f', false)),
      at_once("M110 N2147483\n" + numbered(2'147'484, move)),
      at_once("M110 N5\n" + numbered(6, move) + numbered(6, move) + numbered(9, move) +
              numbered(7, "M105")),
      at_once("M110 N5\n" + numbered(6, move).insert(4, 1, 'X') + numbered(7, "M105")),
      at_once("G92 X10000000 Y-1000000000 Z-1000000000 E1000000000\nM114\nM154 S1\nM155 S1\n"),
      at_once("M211 S0\nG92 X50 Y50 Z10 E0\nG2 X70 Y50 I10 J0 E5 F9000\nG3 X50 Y50 R10 E1\n"),
      at_once("G17\nG2 X100000 Y1 I99999 J-0.0001 F1\nG3 X1 Y1 R0.0000001\n"),
      at_once("G2X99.1Y101.9Z12.3E.12R-323.000123F7654.321\n"),
      at_once(std::string(arc_beyond)),
      at_once("G28\n"),
      at_once(many_words()),
      at_once(std::move(arcs_beyond)),
      at_once("M104 S200\nM140 S60\nM106 S255\nM105\n"),
      at_once("M503\nM115\nM119\nM122\nM114\n"),
      at_once(
          "M92 X80.123456 Y80.654321 Z400.111111 E93.222222\nM203 X1 Y2 Z3 E4\nM201 X9 Y8 Z7\n"),
  };
  return inputs;
}

}  // namespace worst_inputs
