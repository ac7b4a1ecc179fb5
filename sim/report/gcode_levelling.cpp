// SPDX-License-Identifier: Apache-2.0
// G29, G30, M420, M421 and M851: what becomes of the mesh, and where probing leaves the nozzle.
#include <algorithm>
#include <cmath>

#include "sim/report/gcode_path.hpp"

namespace report {

namespace {

constexpr std::string_view straight_axes = "XYZ";
constexpr std::size_t height = 2;

std::int64_t whole(std::optional<std::int64_t> value, std::int64_t otherwise) {
  return value ? *value / billionths : otherwise;
}

}  // namespace

Femtometers femtometers(double millimeters) {
  return std::llround(millimeters * static_cast<double>(femtometers_per_mm));
}

// Whether the line is one of them.
bool GcodePath::read_levelling(const GcodeWords& words, Request& request) {
  if (!facts_.probe) return false;
  if (words.is('G', 29)) {
    request = probe_bed(words);
  } else if (words.is('G', 30)) {
    request = probe_place(words);
  } else if (words.is('M', 420)) {
    const bool follow = words.has('S') ? whole(words.value('S'), 1) != 0 : levelling_.active();
    const auto fade = length(words, 'Z');
    relevel(follow, [&](Levelling& levelling) {
      if (fade) levelling.mesh.set_fade_height(millimeters(*fade));
    });
  } else if (words.is('M', 421)) {
    relevel(levelling_.active(), [&](Levelling& levelling) { set_point(words, levelling.mesh); });
  } else if (words.is('M', 851)) {
    for (std::size_t i = 0; i < straight_axes.size(); ++i) {
      if (const auto offset = length(words, straight_axes[i])) {
        levelling_.offset_mm[i] = millimeters(*offset);
      }
    }
  } else {
    return false;
  }
  return true;
}

// The nozzle stays; Z is called otherwise.
void GcodePath::relevel(bool follow, const std::function<void(Levelling&)>& change) {
  const Point before = nozzle();
  change(levelling_);
  levelling_.follow(follow);
  const Femtometers z = uncorrected(before)[height];
  logical_[height] += z - machine_[height];
  machine_[height] = z;
}

Point GcodePath::uncorrected(Point nozzle) const {
  if (const BedMesh* mesh = levelling_.followed().get()) {
    nozzle[height] = femtometers(mesh->uncorrected_z(millimeters(nozzle[0]), millimeters(nozzle[1]),
                                                     millimeters(nozzle[height])));
  }
  return nozzle;
}

// I and J: -1 or none is all of them.
void GcodePath::set_point(const GcodeWords& words, BedMesh& mesh) const {
  const std::int64_t asked_column = whole(words.value('I'), -1);
  const std::int64_t asked_row = whole(words.value('J'), -1);
  for (std::size_t row = 0; row < mesh.lines()[1].points; ++row) {
    for (std::size_t column = 0; column < mesh.lines()[0].points; ++column) {
      const bool meant = (asked_column < 0 || asked_column == static_cast<std::int64_t>(column)) &&
                         (asked_row < 0 || asked_row == static_cast<std::int64_t>(row));
      if (!meant) continue;
      std::optional<double>& point = mesh.height(column, row);
      if (const auto value = length(words, 'Z')) point = millimeters(*value);
      if (const auto added = length(words, 'Q'); added && point) *point += millimeters(*added);
    }
  }
}

// L to R on X and F to B on Y, as the file calls these places.
Request GcodePath::probe_bed(const GcodeWords& words) {
  constexpr std::array<std::string_view, 2> borders{"LR", "FB"};
  std::array<MeshLines, 2> lines = facts_.probe->lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto place = [&](char letter, double otherwise) {
      const auto asked = length(words, letter);
      return asked ? millimeters(*asked - logical_[i] + machine_[i]) : otherwise;
    };
    lines[i].first = place(borders[i][0], lines[i].first);
    lines[i].last = place(borders[i][1], lines[i].last);
    const std::int64_t points =
        whole(words.value(straight_axes[i]), static_cast<std::int64_t>(lines[i].points));
    constexpr std::int64_t most_points = 15;
    if (points < 2 || points > most_points || lines[i].last <= lines[i].first) return NoMotion{};
    lines[i].points = static_cast<std::size_t>(points);
  }
  relevel(false, [&](Levelling& levelling) {
    levelling.mesh = BedMesh(lines, levelling.mesh.fade_height_mm());
  });
  // There and back, row by row.
  for (std::size_t row = 0; row < lines[1].points; ++row) {
    for (std::size_t i = 0; i < lines[0].points; ++i) {
      const std::size_t column = row % 2 == 0 ? i : lines[0].points - 1 - i;
      levelling_.mesh.height(column, row) = probe_at(lines[0].at(column), lines[1].at(row));
    }
  }
  const Point end = nozzle();
  relevel(true, [](Levelling&) {});
  return Probing{end};
}

Request GcodePath::probe_place(const GcodeWords& words) {
  relevel(false, [](Levelling&) {});
  std::array<double, 2> place{};
  for (std::size_t i = 0; i < place.size(); ++i) {
    const auto asked = length(words, straight_axes[i]);
    place[i] = millimeters(machine_[i]) + levelling_.offset_mm[i];
    if (asked) place[i] = millimeters(*asked - logical_[i] + machine_[i]);
  }
  probe_at(place[0], place[1]);
  return Probing{nozzle()};
}

// Down step by step until the probe triggers; the height by this step. The nozzle ends at
// the clearance.
double GcodePath::probe_at(double x, double y) {
  const ProbeFacts& probe = *facts_.probe;
  const std::array<double, 3>& offset = levelling_.offset_mm;
  Point place = machine_;
  place[0] = femtometers(x - offset[0]);
  place[1] = femtometers(y - offset[1]);
  std::array<double, 2> probed{};
  for (std::size_t i = 0; i < probed.size(); ++i) {
    const double steps_per_mm = facts_.steps_per_mm[i];
    probed[i] =
        std::round(millimeters(place[i]) * steps_per_mm) / steps_per_mm + probe.offset_mm[i];
  }
  const double steps_per_mm = facts_.steps_per_mm[height];
  const double wanted = probe.bed_mm(probed[0], probed[1]) - probe.offset_mm[height];
  double step = std::ceil(wanted * steps_per_mm);
  while (step / steps_per_mm > wanted) --step;
  const double nozzle_z = step / steps_per_mm;
  place[height] = femtometers(std::max(nozzle_z, probe.clearance_mm));
  lead_to(place);
  return nozzle_z + offset[height];
}

}  // namespace report
