// SPDX-License-Identifier: Apache-2.0
// Interprets the motion codes of a G-code file with exact decimals (10^-5 mm).
#include "tests/scenarios/requested_moves.hpp"

#include <cctype>
#include <cmath>
#include <complex>
#include <fstream>
#include <map>
#include <numbers>
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
  Interpreter(const std::array<double, axes>& steps_per_mm, const MachineShape& shape)
      : steps_per_mm_(steps_per_mm), shape_(shape) {}

  void line(int number, const std::string& text) {
    const Words words = words_of(text);
    if (const auto g = words.find('G'); g != words.end() && g->second) {
      switch (static_cast<int>(*g->second)) {
        case 0:
        case 1:
          move(number, words);
          break;
        case 2:
        case 3:
          arc(number, words, *g->second == 2);
          break;
        case 17:
        case 18:
        case 19:
          plane_ = planes[static_cast<std::size_t>(*g->second) - 17];
          break;
        case 10:
          retract(number);
          break;
        case 11:
          recover(number);
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
      if (*m->second == 207) {
        length_ = value(words, 'S', length_);
        lift_ = value(words, 'Z', lift_);
      }
      if (*m->second == 208) extra_ = value(words, 'S', extra_);
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

  // By complex numbers: the end as seen from the centre, divided by the start.
  void arc(int number, const Words& words, bool clockwise) {
    using Complex = std::complex<double>;
    const auto place = [&] {
      return Complex(static_cast<double>(physical_[plane_[0]]) * unit_mm,
                     static_cast<double>(physical_[plane_[1]]) * unit_mm);
    };
    const auto number_of = [&](char letter) {
      const auto word = words.find(letter);
      return word == words.end() ? 0.0 : word->second.value_or(0.0);
    };
    const Complex start = place();
    move(number, words);
    const Complex end = place();
    Complex centre = start + Complex(number_of("IJK"[plane_[0]]), number_of("IJK"[plane_[1]]));
    if (words.contains('R')) {
      const double radius = number_of('R');
      const Complex half = (end - start) / 2.0;
      const double height = std::sqrt(std::max(0.0, radius * radius - std::norm(half)));
      const Complex left = half * Complex(0, 1) / std::abs(half) * height;
      centre = start + half + ((radius > 0) == clockwise ? -left : left);
    }
    double sweep = start == end ? 0 : std::arg((end - centre) / (start - centre));
    if (clockwise && sweep >= 0) sweep -= 2 * std::numbers::pi;
    if (!clockwise && sweep <= 0) sweep += 2 * std::numbers::pi;
    moves_.back().arc = RequestedArc{.plane = plane_,
                                     .centre = {centre.real(), centre.imag()},
                                     .start_radius = std::abs(start - centre),
                                     .end_radius = std::abs(end - centre),
                                     .sweep = sweep};
  }

  static std::int64_t value(const Words& words, char letter, std::int64_t otherwise) {
    const auto word = words.find(letter);
    return word == words.end() || !word->second ? otherwise : units(*word->second);
  }

  // By as much as the machine is elsewhere, so is the origin of the file's coordinates.
  void shift(int number, std::size_t axis, std::int64_t distance) {
    if (distance == 0) return;
    physical_[axis] += distance;
    offset_[axis] += distance;
    add(number, false, {});
  }

  void retract(int number) {
    if (drawn_back_) return;
    drawn_back_ = {length_, lift_};
    shift(number, 3, -length_);
    shift(number, 2, lift_);
  }

  void recover(int number) {
    if (!drawn_back_) return;
    shift(number, 2, -drawn_back_->second);
    shift(number, 3, drawn_back_->first + extra_);
    drawn_back_.reset();
  }

  void home(int number, const Words& words) {
    std::array<bool, axes> homed{};
    bool some = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      some |= homed[axis] = words.contains(letters[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!some || !shape_.is_straight()) homed[axis] = true;
      if (!homed[axis]) continue;
      physical_[axis] = units(shape_.home()[axis]);
      offset_[axis] = 0;
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
    RequestedMove move{.line = number,
                       .homing = homing,
                       .homed = homed,
                       .tool = {},
                       .steps = {},
                       .exact_steps = {},
                       .arc = {}};
    for (std::size_t axis = 0; axis < move.tool.size(); ++axis) {
      move.tool[axis] = static_cast<double>(physical_[axis]) * unit_mm;
    }
    const Vector motors = shape_.motors_of(move.tool);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double place =
          axis < motors.size() ? motors[axis] : static_cast<double>(physical_[axis]) * unit_mm;
      move.exact_steps[axis] = place * steps_per_mm_[axis];
      // Half away from zero; the tiny slack keeps binary fractions from turning an exact half.
      const double slack = std::copysign(1e-9, move.exact_steps[axis]);
      move.steps[axis] = std::llround(move.exact_steps[axis] + slack);
    }
    moves_.push_back(move);
  }

  using Plane = std::array<std::size_t, 2>;
  static constexpr std::array<Plane, 3> planes{{{0, 1}, {2, 0}, {1, 2}}};

  std::array<double, axes> steps_per_mm_;
  MachineShape shape_;
  Plane plane_ = planes[0];
  std::array<std::int64_t, axes> physical_{};  // 10^-5 mm
  std::array<std::int64_t, axes> offset_{};  // physical - logical
  std::int64_t length_ = 300'000, lift_ = 0, extra_ = 0;  // M207, M208: Marlin's, in 10^-5 mm
  std::optional<std::pair<std::int64_t, std::int64_t>> drawn_back_;  // by G10: length and lift
  bool relative_ = false;
  bool relative_e_ = false;
  std::vector<RequestedMove> moves_;
};

}  // namespace

std::vector<RequestedMove> requested_moves(const std::filesystem::path& gcode,
                                           const std::array<double, axes>& steps_per_mm,
                                           const MachineShape& shape) {
  std::ifstream file(gcode);
  if (!file) throw std::runtime_error("cannot read " + gcode.string());
  Interpreter interpreter(steps_per_mm, shape);
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) interpreter.line(number, text);
  return interpreter.take();
}

}  // namespace scenarios
