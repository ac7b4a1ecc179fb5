// SPDX-License-Identifier: Apache-2.0
// Interprets the motion codes of a G-code file with exact decimals (10^-5 mm).
#include "tests/scenarios/requested_moves.hpp"

#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace scenarios {
namespace {

constexpr double unit_mm = 1e-5;  // the finest that slicers write

using Words = std::map<char, std::optional<double>>;

// The words of a line: letter -> number, or nothing for a bare letter.
Words words_of(std::string line) {
  line = line.substr(0, line.find(';'));
  Words words;
  for (std::size_t at = 0; at < line.size();) {
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(line[at++])));
    if (!std::isalpha(static_cast<unsigned char>(letter))) continue;
    const char* start = line.c_str() + at;
    char* end = nullptr;
    const double number = std::strtod(start, &end);
    words[letter] = end == start ? std::nullopt : std::optional(number);
    at += static_cast<std::size_t>(end - start);
  }
  return words;
}

class Interpreter {
 public:
  explicit Interpreter(const std::array<double, axes>& steps_per_mm)
      : steps_per_mm_(steps_per_mm) {}

  void line(int number, const std::string& text) {
    const Words words = words_of(text);
    if (const auto g = words.find('G'); g != words.end() && g->second) {
      switch (static_cast<int>(*g->second)) {
        case 0:
        case 1:
          move(number, words);
          break;
        case 28:
          home(number, words);
          break;
        case 90:
          relative_ = relative_e_ = false;
          break;
        case 91:
          relative_ = relative_e_ = true;
          break;
        case 92:
          set_position(words);
          break;
        default:
          break;
      }
    } else if (const auto m = words.find('M'); m != words.end() && m->second) {
      if (*m->second == 82) relative_e_ = false;
      if (*m->second == 83) relative_e_ = true;
    }
  }

  std::vector<RequestedMove> take() { return std::move(moves_); }

 private:
  static constexpr char letters[axes + 1] = "XYZE";

  static std::int64_t units(double mm) { return std::llround(mm / unit_mm); }

  void move(int number, const Words& words) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const auto word = words.find(letters[axis]);
      if (word == words.end() || !word->second) continue;
      const bool relative = axis == 3 ? relative_e_ : relative_;
      physical_[axis] = units(*word->second) + (relative ? physical_[axis] : offset_[axis]);
    }
    add(number, false, {});
  }

  void home(int number, const Words& words) {
    std::array<bool, axes> homed{};
    bool some = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      some |= homed[axis] = words.contains(letters[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!some) homed[axis] = true;
      if (homed[axis]) physical_[axis] = offset_[axis] = 0;
    }
    add(number, true, homed);
  }

  void set_position(const Words& words) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const auto word = words.find(letters[axis]);
      if (word == words.end()) continue;
      offset_[axis] = physical_[axis] - units(word->second.value_or(0.0));
    }
  }

  void add(int number, bool homing, const std::array<bool, axes>& homed) {
    RequestedMove move{
        .line = number, .homing = homing, .homed = homed, .steps = {}, .exact_steps = {}};
    for (std::size_t axis = 0; axis < axes; ++axis) {
      move.exact_steps[axis] = static_cast<double>(physical_[axis]) * unit_mm * steps_per_mm_[axis];
      // Half away from zero; the tiny slack keeps binary fractions from turning an exact half.
      const double slack = std::copysign(1e-9, move.exact_steps[axis]);
      move.steps[axis] = std::llround(move.exact_steps[axis] + slack);
    }
    moves_.push_back(move);
  }

  std::array<double, axes> steps_per_mm_;
  std::array<std::int64_t, axes> physical_{};  // 10^-5 mm
  std::array<std::int64_t, axes> offset_{};  // physical - logical
  bool relative_ = false;
  bool relative_e_ = false;
  std::vector<RequestedMove> moves_;
};

}  // namespace

std::vector<RequestedMove> requested_moves(const std::filesystem::path& gcode,
                                           const std::array<double, axes>& steps_per_mm) {
  std::ifstream file(gcode);
  if (!file) throw std::runtime_error("cannot read " + gcode.string());
  Interpreter interpreter(steps_per_mm);
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) interpreter.line(number, text);
  return interpreter.take();
}

}  // namespace scenarios
