// SPDX-License-Identifier: Apache-2.0
// A small interpreter of the G-codes that move, in floating point and millimetres.
#include "sim/report/gcode_path.hpp"

#include <cctype>
#include <charconv>
#include <optional>

namespace report {

namespace {

constexpr std::string_view axis_words = "XYZE";
constexpr double inch_mm = 25.4;

char upper(char character) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
}

double number_at(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" +");
  double value = 0;
  if (first != std::string_view::npos) {
    std::from_chars(text.data() + first, text.data() + text.size(), value);
  }
  return value;
}

bool has_word(std::string_view words, char letter) {
  for (const char character : words) {
    if (upper(character) == letter) {
      return true;
    }
  }
  return false;
}

std::optional<double> word(std::string_view words, char letter) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (upper(words[i]) == letter) {
      return number_at(words.substr(i + 1));
    }
  }
  return std::nullopt;
}

}  // namespace

Request GcodePath::read(std::string_view command) {
  if (command.empty()) {
    return NoMotion{};
  }
  const char letter = upper(command.front());
  const int code = static_cast<int>(number_at(command.substr(1)));
  const std::size_t end = command.find_first_not_of("0123456789. ", 1);
  const std::string_view words = end == std::string_view::npos ? "" : command.substr(end);
  if (letter == 'G') {
    switch (code) {
      case 0:
      case 1:
        return move(words);
      case 20:
        unit_mm_ = inch_mm;
        break;
      case 21:
        unit_mm_ = 1.0;
        break;
      case 28:
        return home(words);
      case 90:
        absolute_ = extruder_absolute_ = true;
        break;
      case 91:
        absolute_ = extruder_absolute_ = false;
        break;
      case 92:
        set_position(words);
        break;
      default:
        break;
    }
  } else if (letter == 'M') {
    switch (code) {
      case 82:
        extruder_absolute_ = true;
        break;
      case 83:
        extruder_absolute_ = false;
        break;
      case 104:
      case 109:
      case 140:
      case 190:
        if (const std::optional<double> celsius = word(words, has_word(words, 'S') ? 'S' : 'R')) {
          return TemperatureTarget{code == 140 || code == 190, *celsius,
                                   code == 109 || code == 190};
        }
        break;
      default:
        break;
    }
  }
  return NoMotion{};
}

Request GcodePath::move(std::string_view words) {
  Move move{position_, position_};
  bool any = false;
  for (std::size_t i = 0; i < axis_words.size(); ++i) {
    if (const std::optional<double> value = word(words, axis_words[i])) {
      const bool absolute = i == 3 ? extruder_absolute_ : absolute_;
      move.to[i] = *value * unit_mm_ + (absolute ? offset_[i] : position_[i]);
      any = true;
    }
  }
  if (!any) {
    return NoMotion{};
  }
  position_ = move.to;
  return move;
}

Request GcodePath::home(std::string_view words) {
  const bool all = !has_word(words, 'X') && !has_word(words, 'Y') && !has_word(words, 'Z');
  Homing homing;
  for (std::size_t i = 0; i < homing.axes.size(); ++i) {
    homing.axes[i] = all || has_word(words, axis_words[i]);
    if (homing.axes[i]) {
      position_[i] = 0;
      offset_[i] = 0;
    }
  }
  return homing;
}

void GcodePath::set_position(std::string_view words) {
  const bool all = words.empty();
  for (std::size_t i = 0; i < axis_words.size(); ++i) {
    const std::optional<double> value = word(words, axis_words[i]);
    if (value || all) {
      offset_[i] = position_[i] - value.value_or(0.0) * unit_mm_;
    }
  }
}

}  // namespace report
