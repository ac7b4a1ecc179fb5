// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/hard_inputs.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "host_link/line_queue.hpp"
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

// As a host sends them: no more at once than the printer takes.
template <class Line>
void send_in_turn(SerialInput& input, int count, Line line) {
  constexpr int at_once = static_cast<int>(host_link::LineQueue::capacity);
  for (int i = 0; i < count; ++i) {
    if (i % at_once == 0) input.push_back({.pause_us = 0, .bytes = {}, .waits = true});
    input.back().bytes += line(i);
  }
}

// On and on, with so little acceleration that each line makes many before it faster; of all axes,
// each at another angle to the one before, by this command's corners.
SerialInput slow_lines(std::string_view corners) {
  SerialInput input{
      {.pause_us = 0, .bytes = fmt::format("M83\nM204 P20 T20\nM205 {}\nG1 F12000\n", corners)}};
  send_in_turn(input, 56, [](int i) {
    const int line = i + 1;
    return fmt::format("G1X{:.1f}Y{:.1f}Z{:.1f}E.1{}\n", 100 + 1.3 * line + line % 2,
                       100 + 1.1 * line - line % 3, 10 + 0.3 * line + 0.2 * (line % 2), line % 3);
  });
  return input;
}

// The smallest lines that a machine is given, as a host sends them: the step generator takes four
// at once. Behind them more lines, without waiting.
SerialInput small_lines(double millimeters, int acceleration, int jerk, std::string_view behind) {
  SerialInput input{{.pause_us = 0,
                     .bytes = fmt::format("M83\nM201 X{0} Y{0} E{0}\nM204 P{0} T{0}\n"
                                          "M203 X300 Y300 E200\nM205 X{1} Y{1} E{1}\n"
                                          "G1 F18000\n",
                                          acceleration, jerk)}};
  send_in_turn(input, 24, [millimeters](int line) {
    return fmt::format("G1X{:.2f}Y{:.2f}E.005\n", 100 + millimeters * (line % 2),
                       100 + millimeters * (line / 2 % 2));
  });
  input.push_back({.pause_us = 0, .bytes = std::string(behind), .waits = true});
  return input;
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
  for (int i = 0; i < 5; ++i) arcs_beyond += arc_beyond;
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
      slow_lines("X30 Y30 Z5 E20"),
      slow_lines("J0.02"),
      small_lines(0.08, 20'000, 5, arcs_beyond),
      small_lines(0.1, 20'000, 1, arcs_beyond),
      small_lines(0.12, 20'000, 1, arcs_beyond),
      at_once("M104 S200\nM140 S60\nM106 S255\nM105\n"),
      at_once("M503\nM115\nM119\nM122\nM114\n"),
      at_once(
          "M92 X80.123456 Y80.654321 Z400.111111 E93.222222\nM203 X1 Y2 Z3 E4\nM201 X9 Y8 Z7\n"),
  };
  return inputs;
}

}  // namespace worst_inputs
