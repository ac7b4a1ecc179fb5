// SPDX-License-Identifier: Apache-2.0
// T, M217 and M218: from the old nozzle's place to the new one's. M603, M701 and M702.
#include <algorithm>
#include <utility>

#include "sim/report/gcode_path.hpp"

namespace report {

namespace {

constexpr std::string_view straight_axes = "XYZ";
constexpr std::size_t height = 2;

}  // namespace

// T of a command, or the tool in use.
std::size_t GcodePath::tool_of(const GcodeWords& words) const {
  if (!facts_.second_tool) return 0;
  const std::int64_t tool =
      words.value('T').value_or(static_cast<std::int64_t>(tool_) * billionths) / billionths;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(tool, 0, 1));
}

void GcodePath::set_change(const GcodeWords& words) {
  const auto take = [&](char letter, Femtometers least, Femtometers most, Femtometers& value) {
    if (const auto asked = length(words, letter)) value = std::clamp(*asked, least, most);
  };
  constexpr Femtometers most_swap = 200 * femtometers_per_mm, most_resume = 10 * femtometers_per_mm;
  take('S', 0, most_swap, change_.swap);
  take('B', -most_resume, most_resume, change_.resume);
  take('E', 0, most_swap, change_.prime);
  take('Z', 0, facts_.travel[height], change_.lift);
}

// The nozzle in use is where it is, and is called otherwise.
void GcodePath::set_offset(const GcodeWords& words) {
  if (tool_of(words) == 0) {
    return;  // a tool 0 that is elsewhere than the machine is not judged
  }
  for (std::size_t i = 0; i < straight_axes.size(); ++i) {
    const auto value = length(words, straight_axes[i]);
    if (!value) continue;
    if (tool_ != 0) logical_[i] += *value - change_.offset[i];
    change_.offset[i] = *value;
  }
}

// From rest to rest: the old filament back, Z up, the new filament forward, X and Y, Z down.
Request GcodePath::change_tool(const GcodeWords& words) {
  const std::int64_t number = words.all().front().value.value_or(0) / billionths;
  if (!facts_.second_tool || number < 0 || number > 1) return NoMotion{};
  const auto tool = static_cast<std::size_t>(number);
  if (tool == tool_ && drawn_[tool] == 0) return NoMotion{};
  std::array<Femtometers, 3> target{};
  bool moves = tool != tool_ && words.value('S').value_or(0) < billionths;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const Femtometers way = (tool == 0 ? 0 : change_.offset[i]) - offset(i);
    target[i] = machine_[i] - way;
    moves = moves && homed_[i] && target[i] >= 0 && target[i] <= facts_.travel[i];
    logical_[i] += way;
  }
  ToolMoves all;
  const auto go = [&](const Point& place) {
    if (place == machine_) return;
    for (std::size_t i = 0; i < target.size(); ++i) logical_[i] += place[i] - machine_[i];
    all.moves.push_back({machine_, place, {}});
    machine_ = place;
  };
  const auto extrude = [&](Femtometers distance) {
    Point place = machine_;
    place[extruder_motor()] += distance;
    go(place);
  };
  Point place = machine_;
  if (moves) {
    drawn_[tool_] += change_.swap;
    extrude(-change_.swap);
    place = machine_;
    const Femtometers higher = std::max(machine_[height], target[height]);
    place[height] = std::max(higher, std::min(higher + change_.lift, facts_.travel[height]));
    go(place);
  }
  tool_ = tool;
  // Where the nozzle stays, its filament comes forward all the same.
  const Femtometers forward = std::exchange(drawn_[tool_], 0);
  extrude(forward);
  if (moves) {
    extrude(change_.prime);
    place = machine_;
    place[0] = target[0];
    place[1] = target[1];
    go(place);
    place[height] = target[height];
    go(place);
  }
  if (forward != 0) extrude(change_.resume);
  return all;
}

// Up, the filament, and down again; the file's coordinates do not show it.
Request GcodePath::move_filament(const GcodeWords& words) {
  if (!facts_.filament) return NoMotion{};
  FilamentFacts& filament = *facts_.filament;
  const auto size = [&](char letter, Femtometers otherwise) {
    const Femtometers value = length(words, letter).value_or(otherwise);
    return value < 0 ? -value : value;
  };
  const bool loads = words.is('M', 701);
  const Femtometers load = size('L', filament.load), unload = size('U', filament.unload);
  if (words.is('M', 603)) {
    filament.load = load;
    filament.unload = unload;
    return NoMotion{};
  }
  ToolMoves all;
  const auto go = [&](std::size_t axis, Femtometers distance) {
    if (distance == 0) return;
    Move move{machine_, machine_, {}};
    move.to[axis] += distance;
    machine_ = move.to;
    all.moves.push_back(move);
  };
  const Femtometers lift = size('Z', 0);
  go(height, lift);
  go(extruder_motor(), loads ? load : -unload);
  go(extruder_motor(), loads ? filament.purge : 0);
  go(height, -lift);
  return all;
}

}  // namespace report
