// SPDX-License-Identifier: Apache-2.0
// A small interpreter of the G-codes that move, in whole femtometres.
#include "sim/report/gcode_path.hpp"

#include <algorithm>

namespace report {

namespace {

constexpr std::string_view axis_words = "XYZE";
constexpr std::size_t height = 2;
constexpr std::size_t extruder = 3;
constexpr Femtometers per_billionth_mm = femtometers_per_mm / billionths;
constexpr Femtometers per_billionth_inch = 25'400;

template <class... Codes>
bool is_any(const GcodeWords& words, char letter, Codes... codes) {
  return (words.is(letter, codes) || ...);
}

}  // namespace

Request GcodePath::read(std::string_view command) {
  const GcodeWords words(command);
  if (facts_.shaping) read_shaping(words, command);
  Request request = read_line(words);
  const auto complete = [&](Move& move) {
    move.mesh = levelling_.followed();
    hold_back(move);
  };
  if (Move* move = std::get_if<Move>(&request)) complete(*move);
  if (ToolMoves* all = std::get_if<ToolMoves>(&request)) {
    std::ranges::for_each(all->moves, complete);
  }
  return request;
}

Request GcodePath::read_line(const GcodeWords& words) {
  Request request = NoMotion{};
  if (!words.all().empty() && words.all().front().letter == 'T') return change_tool(words);
  if (words.is('G', 53)) {
    const GcodeWords line = words.without_first();
    return is_any(line, 'G', 0, 1, 2, 3) ? move(line, true) : Request(NoMotion{});
  }
  if (words.is('M', 290)) request = Babystep{};
  if (words.is('M', 425)) return set_play(words);
  if (is_any(words, 'M', 603, 701, 702)) return move_filament(words);
  if (read_coordinates(words) || read_levelling(words, request)) return request;
  if (!words.all().empty() && words.all().front().letter == 'G') {
    read_g(words, request);
  } else {
    read_m(words, request);
  }
  return request;
}

void GcodePath::read_g(const GcodeWords& words, Request& request) {
  if (is_any(words, 'G', 0, 1, 2, 3)) {
    request = move(words);
  } else if (words.is('G', 10)) {
    request = retract();
  } else if (words.is('G', 11)) {
    request = recover();
  } else if (is_any(words, 'G', 17, 18, 19)) {
    plane_ = words.is('G', 17) ? 0 : words.is('G', 18) ? 1 : 2;
  } else if (is_any(words, 'G', 20, 21)) {
    inches_ = words.is('G', 20);
  } else if (words.is('G', 27)) {
    request = park(words);
  } else if (words.is('G', 28)) {
    request = home(words);
  } else if (words.is('G', 60)) {
    save(words);
  } else if (words.is('G', 61)) {
    request = restore(words);
  } else if (is_any(words, 'G', 90, 91)) {
    absolute_ = extruder_absolute_ = words.is('G', 90);
  } else if (words.is('G', 92)) {
    set_position(words);
  }
}

void GcodePath::read_m(const GcodeWords& words, Request& request) {
  if (is_any(words, 'M', 82, 83)) {
    extruder_absolute_ = words.is('M', 82);
  } else if (is_any(words, 'M', 104, 109, 140, 190)) {
    const bool waits = is_any(words, 'M', 109, 190);
    const auto target = words.value(waits && words.has('R') ? 'R' : 'S');
    if (target) {
      request = TemperatureTarget{is_any(words, 'M', 140, 190),
                                  celsius(static_cast<double>(*target) / billionths), waits,
                                  tool_of(words)};
    }
  } else if (words.is('M', 149) && words.all().size() > 1) {
    temperature_unit_ = words.has('C') ? 'C' : words.has('K') ? 'K' : 'F';
  } else if (words.is('M', 92)) {
    NewResolution resolution;
    for (std::size_t i = 0; i < axis_words.size(); ++i) {
      resolution.steps_per_mm[i] = words.value(axis_words[i]);
      if (i < facts_.steps_per_mm.size() && resolution.steps_per_mm[i]) {
        facts_.steps_per_mm[i] = static_cast<double>(*resolution.steps_per_mm[i]) / billionths;
      }
    }
    request = resolution;
  } else if (words.is('M', 207)) {
    read_speed(words);
    retraction_.length = length(words, 'S').value_or(retraction_.length);
    retraction_.lift = length(words, 'Z').value_or(retraction_.lift);
  } else if (words.is('M', 208)) {
    read_speed(words);
    retraction_.extra = length(words, 'S').value_or(retraction_.extra);
  } else if (is_any(words, 'M', 501, 502)) {
    if (facts_.probe) {
      relevel(false, [&](Levelling& levelling) { levelling = Levelling(*facts_.probe); });
    }
    retraction_ = facts_.retraction;
    extruder_mm_s_ = facts_.extruder_mm_s;
    retract_mm_s_ = recover_mm_s_ = 0;
    const ToolFacts before = change_;
    change_ = facts_.second_tool.value_or(ToolFacts());
    for (std::size_t i = 0; i < height + 1; ++i) {
      if (tool_ != 0) logical_[i] += change_.offset[i] - before.offset[i];
    }
    if (given_.play) {
      facts_.play = given_.play;
      request = play();
    }
  } else if (words.is('M', 217)) {
    set_change(words);
  } else if (words.is('M', 218)) {
    set_offset(words);
  } else if (is_any(words, 'M', 203, 205, 220)) {
    read_speed(words);
  } else if (words.is('M', 221)) {
    // Whole percents, cut as Marlin cuts them.
    std::int64_t& flow = flow_percent_[tool_of(words)];
    flow = words.value('S').value_or(flow * billionths) / billionths;
  } else if (words.is('M', 400)) {
    request = Rest{};
  } else if (words.is('M', 410)) {
    has_jumped_.fill(true);
    request = QuickStop{};
  }
}

// 0 is off in each unit.
double GcodePath::celsius(double temperature) const {
  constexpr double kelvin_at_0_c = 273.15, fahrenheit_at_0_c = 32, kelvin_per_fahrenheit = 5.0 / 9;
  if (temperature_unit_ == 'F') {
    temperature = (temperature - fahrenheit_at_0_c) * kelvin_per_fahrenheit;
  }
  if (temperature_unit_ == 'K') temperature -= kelvin_at_0_c;
  return std::max(temperature, 0.0);
}

std::optional<Femtometers> GcodePath::length(const GcodeWords& words, char letter) const {
  const std::optional<std::int64_t> value = words.value(letter);
  // 10^7 units are further than any machine, and leave room for sums.
  constexpr std::int64_t furthest = 10'000'000 * billionths;
  if (!value || *value > furthest || *value < -furthest) return std::nullopt;
  return Femtometers{*value} * (inches_ ? per_billionth_inch : per_billionth_mm);
}

Request GcodePath::move(const GcodeWords& words, bool machines) {
  Move move{machine_, machine_, {}};
  bool any = false;
  for (std::size_t i = 0; i < axis_words.size(); ++i) {
    const std::optional<Femtometers> value = length(words, axis_words[i]);
    if (!value) continue;
    any = true;
    const bool absolute = i == extruder ? extruder_absolute_ : absolute_;
    const Femtometers zero = machines && i != extruder ? coordinates_.zero(i) : 0;
    const Femtometers distance = absolute ? *value + zero - logical_[i] : *value;
    logical_[i] += distance;
    if (i == extruder) {
      move.to[extruder_motor()] += filament_of(distance / 100 * flow_percent_[tool_]);
    } else {
      move.to[i] += distance;
    }
  }
  read_speed(words);
  if (feed_mm_s_ > 0) {
    const double asked = feed_mm_s_ * static_cast<double>(speed_percent_) / 100;
    move.speed_mm_s = std::max({asked, least_mm_s_[0], least_mm_s_[1]});
  }
  const bool straight = is_any(words, 'G', 0, 1);
  if (straight && (move.to[0] != move.from[0] || move.to[1] != move.from[1])) {
    move.to[height] += babystep_;
    babystep_ = 0;
  }
  machine_ = move.to;
  move.arc = arc_of(words, move);
  any = any || move.arc;
  return any ? Request(move) : Request(NoMotion{});
}

std::optional<ArcShape> GcodePath::arc_of(const GcodeWords& words, const Move& move) const {
  if (!is_any(words, 'G', 2, 3)) return std::nullopt;
  constexpr std::array<std::array<std::size_t, 2>, 3> planes{{{0, 1}, {2, 0}, {1, 2}}};
  constexpr std::string_view offset_words = "IJK";
  const bool clockwise = words.is('G', 2);
  std::array<double, 2> from{}, to{}, offset{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = planes[plane_][i];
    from[i] = millimeters(move.from[axis]);
    to[i] = millimeters(move.to[axis]);
    offset[i] = millimeters(length(words, offset_words[axis]).value_or(0));
  }
  if (const auto radius = length(words, 'R')) {
    offset = offset_by_radius(from, to, millimeters(*radius), clockwise);
  }
  ArcShape arc = arc_about(from, to, offset, clockwise);
  arc.first = planes[plane_][0];
  arc.second = planes[plane_][1];
  return arc;
}

Request GcodePath::home(const GcodeWords& words) {
  relevel(false, [](Levelling&) {});
  Homing homing;
  const bool all =
      facts_.home.of_all_axes || (!words.has('X') && !words.has('Y') && !words.has('Z'));
  for (std::size_t i = 0; i < homing.axes.size(); ++i) {
    homing.axes[i] = all || words.has(axis_words[i]);
    if (!homing.axes[i]) continue;
    coordinates_.home(i);
    machine_[i] = facts_.home.place[i];
    logical_[i] = facts_.home.place[i] + coordinates_.zero(i) + offset(i);
    homed_[i] = true;
    if (i == height) babystep_ = 0;
  }
  has_jumped_.fill(true);
  return homing;
}

// The filament first, then Z. What the file calls the place stays as it is.
Request GcodePath::retract() {
  if (retracted_[tool_]) return NoMotion{};
  Move move{machine_, machine_, {}};
  move.extruder_mm_s = retract_mm_s_;
  move.to[extruder_motor()] -= retraction_.length;
  if (retraction_.lift != 0) move.over = move.to;
  move.to[height] += retraction_.lift;
  machine_ = move.to;
  retracted_[tool_] = retraction_;
  above_file_[tool_] = machine_[height] + offset(height) - logical_[height];
  has_jumped_[tool_] = false;
  return move;
}

// Z first. After a stop or homing the chip does not lower Z. Unless the file or homing has said
// since what the place is called, it is higher by the lift.
Request GcodePath::recover() {
  std::optional<Retraction>& retracted = retracted_[tool_];
  if (!retracted) return NoMotion{};
  Move move{machine_, machine_, {}};
  move.extruder_mm_s = recover_mm_s_;
  move.to[extruder_motor()] += retracted->length + retraction_.extra;
  if (!has_jumped_[tool_]) {
    if (retracted->lift != 0) {
      move.over = move.from;
      (*move.over)[height] -= retracted->lift;
    }
    move.to[height] -= retracted->lift;
  } else if (machine_[height] + offset(height) - logical_[height] == above_file_[tool_]) {
    logical_[height] += retracted->lift;
  }
  machine_ = move.to;
  retracted.reset();
  return move;
}

void GcodePath::set_position(const GcodeWords& words) {
  for (std::size_t i = 0; i < axis_words.size(); ++i) {
    const auto value = length(words, axis_words[i]);
    if (!value) continue;
    if (i != extruder) coordinates_.move_by(i, *value - logical_[i]);
    logical_[i] = *value;
  }
}

}  // namespace report
