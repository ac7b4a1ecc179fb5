// SPDX-License-Identifier: Apache-2.0
// Lines about probe and mesh.
#include "application/levelling_reports.hpp"

#include "units/loop_bound.hpp"

namespace application {
namespace {

using units::Nanometers;
using std::literals::operator""sv;

void put(host_link::TextLine& line, char letter, Nanometers length, bool inches) {
  line.character(' ').character(letter);
  line.decimal(inches ? length.count() * 10 / 254 : length.count(), 6, inches ? 3 : 2);
}

}  // namespace

host_link::TextLine levelling_report(std::size_t index, const motion::Levelling& levelling,
                                     bool inches) {
  host_link::TextLine line;
  if (index == 0) {
    line.text("echo: M420 S").integer(levelling.active ? 1 : 0);
    put(line, 'Z', levelling.mesh.fade_height(), inches);
    return line;
  }
  line.text("echo: M851");
  for (std::size_t i = 0; i < levelling.probe.offset.size(); ++i) {
    put(line, units::axis_letters[i], levelling.probe.offset[i], inches);
  }
  return line;
}

host_link::TextLine mesh_line(std::size_t index, const motion::BedMesh& mesh) {
  constexpr std::size_t one_digit = 10;
  host_link::TextLine line;
  if (index == 0) {
    line.text("Bilinear Leveling Grid:");
    return line;
  }
  const bool titles = index < mesh_titles;
  const std::size_t row = titles ? 0 : index - mesh_titles;
  if (!titles) {
    if (row < one_digit) line.character(' ');
    line.integer(static_cast<std::int64_t>(row));
  }
  units::LoopBound<motion::BedMesh::most_points> columns;
  for (std::size_t column = 0; column < mesh.points(0); ++column) {
    columns.next();
    if (titles) {
      line.text(column < one_digit ? "      "sv : "     "sv);
      line.integer(static_cast<std::int64_t>(column));
      continue;
    }
    const auto height = mesh.height(column, row);
    if (!height) {
      line.text("  =====");
      continue;
    }
    line.character(' ');
    // What is rounded to 0 has no sign of its own.
    constexpr Nanometers half_micrometer{500};
    if (*height > -half_micrometer) line.character('+');
    line.decimal(height->count(), 6, 3);
  }
  return line;
}

host_link::TextLine probing_failure(const motion::Probing& probing) {
  host_link::TextLine line;
  line.text("Error:Probing Failed at");
  put(line, 'X', probing.x(), false);
  put(line, 'Y', probing.y(), false);
  line.text(": ");
  const auto fault = probing.fault();
  line.text(fault ? motion::describe(*fault) : "bed higher than 10 mm, check M851 Z");
  return line;
}

}  // namespace application
