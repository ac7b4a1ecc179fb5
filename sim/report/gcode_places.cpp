// SPDX-License-Identifier: Apache-2.0
// Codes that change what the file calls a place, and those that lead to places of the machine.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/report/gcode_path.hpp"

namespace report {

namespace {

constexpr std::string_view straight_axes = "XYZ";
constexpr std::size_t height = 2;
constexpr std::size_t extruder = 3;
constexpr Femtometers park_border = 10 * femtometers_per_mm;
constexpr Femtometers park_height = 20 * femtometers_per_mm;

// Of G54 to G59.3.
std::optional<std::size_t> system_of(const GcodeWords& words) {
  if (words.all().empty() || words.all().front().letter != 'G') return std::nullopt;
  const std::int64_t number = words.all().front().value.value_or(0);
  constexpr std::int64_t tenth = billionths / 10;
  for (std::size_t system = 0; system < 9; ++system) {
    const std::int64_t whole = 54 + static_cast<std::int64_t>(std::min<std::size_t>(system, 5));
    const std::int64_t tenths = system > 5 ? static_cast<std::int64_t>(system) - 5 : 0;
    if (number == whole * billionths + tenths * tenth) return system;
  }
  return std::nullopt;
}

}  // namespace

// Whether the line is one of them.
bool GcodePath::read_coordinates(const GcodeWords& words) {
  FileCoordinates changed = coordinates_;
  const bool resets = !words.all().empty() && words.all().front().letter == 'G' &&
                      words.all().front().value == 92 * billionths + billionths / 10;
  if (const auto system = system_of(words)) {
    changed.choose(*system);
  } else if (resets) {
    changed.clear();
  } else {
    return read_offsets(words);
  }
  rename_axes(changed);
  return true;
}

bool GcodePath::read_offsets(const GcodeWords& words) {
  if (words.is('M', 290)) {
    const auto step = length(words, words.has('Z') ? 'Z' : 'S').value_or(0);
    babystep_ += std::clamp(step, -2 * femtometers_per_mm, 2 * femtometers_per_mm);
    return true;
  }
  if (words.is('M', 200)) {
    // In whole micrometres, as the chip says.
    if (const auto diameter = length(words, 'D')) {
      filament_mm_[tool_of(words)] = std::round(millimeters(*diameter) * 1000) / 1000;
    }
    if (words.has('D') || words.has('S')) {
      volumetric_ =
          filament_mm_[tool_of(words)] != 0 && words.value('S').value_or(billionths) >= billionths;
    }
    return true;
  }
  if (!words.is('M', 206) && !words.is('M', 428)) return false;
  FileCoordinates changed = coordinates_;
  for (std::size_t i = 0; i < straight_axes.size(); ++i) {
    auto offset = length(words, straight_axes[i]);
    if (words.is('M', 428)) {
      const Femtometers here = machine_[i] + this->offset(i);
      offset = (here > facts_.travel[i] / 2 ? facts_.travel[i] : 0) - here;
    }
    if (offset) changed.set_home_offset(i, *offset);
  }
  rename_axes(changed);
  return true;
}

void GcodePath::rename_axes(const FileCoordinates& changed) {
  for (std::size_t i = 0; i < straight_axes.size(); ++i) {
    logical_[i] += changed.zero(i) - coordinates_.zero(i);
  }
  coordinates_ = changed;
}

// By the volume of a cylinder.
Femtometers GcodePath::filament_of(Femtometers requested) const {
  const double diameter = filament_mm_[tool_];
  if (!volumetric_ || diameter == 0) return requested;
  const double area = std::numbers::pi * diameter * diameter / 4;
  return static_cast<Femtometers>(std::llround(static_cast<double>(requested) / area));
}

Request GcodePath::lead_to(const Point& place) {
  const Move move{machine_, place, {}};
  for (std::size_t i = 0; i < straight_axes.size(); ++i) logical_[i] += place[i] - machine_[i];
  machine_ = place;
  return move;
}

void GcodePath::stop_at(const Point& nozzle) {
  const Point place = uncorrected(nozzle);
  for (std::size_t i = 0; i < straight_axes.size(); ++i) logical_[i] += place[i] - machine_[i];
  logical_[extruder] += place[extruder_motor()] - machine_[extruder_motor()];
  machine_ = place;
}

Move GcodePath::make_babystep() {
  Move move{machine_, machine_, {}, {}, levelling_.followed()};
  move.to[height] += std::exchange(babystep_, 0);
  machine_ = move.to;
  return move;
}

NewPlay GcodePath::play() const {
  NewPlay play{facts_.play->lengths};
  for (Femtometers& length : play.lengths) {
    length = femtometers(millimeters(length) * facts_.play->part);
  }
  return play;
}

Request GcodePath::set_play(const GcodeWords& words) {
  if (!facts_.play) return NoMotion{};
  for (std::size_t i = 0; i < straight_axes.size(); ++i) {
    if (const auto asked = length(words, straight_axes[i])) facts_.play->lengths[i] = *asked;
  }
  if (const auto part = words.value('F')) {
    facts_.play->part = std::clamp(static_cast<double>(*part) / billionths, 0.0, 1.0);
  }
  return play();
}

Request GcodePath::park(const GcodeWords& words) {
  const std::int64_t manner = words.value('P').value_or(0) / billionths;
  Point place = machine_;
  const Femtometers high = std::min(park_height, facts_.travel[height]);
  if (manner == 0) place[height] = std::max(place[height], high);
  if (manner == 1) place[height] = high;
  if (manner == 2) place[height] = std::min(place[height] + park_height, facts_.travel[height]);
  Move move{machine_, place, {}, place};
  lead_to(place);
  place[0] = std::min(park_border, facts_.travel[0]);
  place[1] = std::max<Femtometers>(facts_.travel[1] - park_border, 0);
  lead_to(place);
  move.to = place;
  return move;
}

void GcodePath::save(const GcodeWords& words) {
  const std::int64_t slot = words.value('S').value_or(0) / billionths;
  if (slot < 0 || slot >= static_cast<std::int64_t>(saved_.size())) return;
  Point place = logical_;
  for (std::size_t i = 0; i < straight_axes.size(); ++i) place[i] -= coordinates_.zero(i);
  saved_[static_cast<std::size_t>(slot)] = place;
}

Request GcodePath::restore(const GcodeWords& words) {
  const std::int64_t slot = words.value('S').value_or(0) / billionths;
  if (slot < 0 || slot >= static_cast<std::int64_t>(saved_.size())) return NoMotion{};
  const auto& saved = saved_[static_cast<std::size_t>(slot)];
  if (!saved) return NoMotion{};
  const bool all = !words.has('X') && !words.has('Y') && !words.has('Z') && !words.has('E');
  Point place = machine_;
  for (std::size_t i = 0; i < straight_axes.size(); ++i) {
    if (!all && !words.has(straight_axes[i])) continue;
    place[i] += (*saved)[i] + coordinates_.zero(i) - logical_[i] +
                length(words, straight_axes[i]).value_or(0);
  }
  Request request = lead_to(place);
  if (all || words.has('E')) logical_[extruder] = (*saved)[extruder];
  return request;
}

}  // namespace report
