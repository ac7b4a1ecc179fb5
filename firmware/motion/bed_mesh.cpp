// SPDX-License-Identifier: Apache-2.0
// Bilinear heights in whole nanometres.
#include "motion/bed_mesh.hpp"

#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion {
namespace {

using units::Nanometers;

constexpr int fraction_bits = 24;  // of a cell
constexpr std::uint32_t one_cell = 1u << fraction_bits;
constexpr std::size_t z = units::index_of(units::Axis::z);

// Rounded to nearest, halves away from 0.
constexpr std::int64_t divided(std::int64_t value, std::int64_t divisor) {
  return (value < 0 ? value - divisor / 2 : value + divisor / 2) / divisor;
}

// `part` of the way from one height to the other.
constexpr std::int64_t between(std::int64_t from, std::int64_t to, std::uint32_t part) {
  return from + (((to - from) * part + one_cell / 2) >> fraction_bits);
}

}  // namespace

void BedMesh::set_axes(const std::array<MeshAxis, 2>& axes) {
  axes_ = axes;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    units::LoopBound<most_points> lines;
    for (std::size_t i = 0; i < axes[axis].points; ++i) {
      lines.next();
      lines_[axis][i] = axes[axis].line(i);
    }
  }
  units::LoopBound<most_points, 1> rows;
  for (auto& row : heights_) {
    rows.next();
    row.fill(unknown);
  }
}

std::optional<Nanometers> BedMesh::height(std::size_t column, std::size_t row) const {
  const Height found = heights_[row][column];
  return found == unknown ? std::nullopt : std::optional(Nanometers(found));
}

bool BedMesh::set_height(std::size_t column, std::size_t row, Nanometers height) {
  if (!may_be(height)) return false;
  heights_[row][column] = static_cast<Height>(height.count());
  return true;
}

bool BedMesh::complete() const {
  units::LoopBound<most_points> rows;
  for (std::size_t row = 0; row < axes_[1].points; ++row) {
    rows.next();
    units::LoopBound<most_points, 1> columns;
    for (std::size_t column = 0; column < axes_[0].points; ++column) {
      columns.next();
      if (heights_[row][column] == unknown) return false;
    }
  }
  return axes_[0].points != 0;
}

Nanometers BedMesh::largest() const {
  std::uint32_t most = 0;
  units::LoopBound<most_points> rows;
  for (std::size_t row = 0; row < axes_[1].points; ++row) {
    rows.next();
    units::LoopBound<most_points, 1> columns;
    for (std::size_t column = 0; column < axes_[0].points; ++column) {
      columns.next();
      if (heights_[row][column] == unknown) continue;
      most = std::max(most, units::magnitude(heights_[row][column]));
    }
  }
  return Nanometers(most);
}

void BedMesh::set_fade_height(Nanometers height) {
  fade_lines_[1] = std::clamp(height, Nanometers(), most_fade_height);
}

std::uint32_t BedMesh::cells(std::size_t axis, const units::Position& place) const {
  const MeshAxis& grid = axes_[axis];
  const Nanometers within = std::clamp(place.nearest(), grid.first, grid.last) - grid.first;
  const auto parts = static_cast<std::uint64_t>(within.count()) * (grid.points - 1u);
  return static_cast<std::uint32_t>((parts << fraction_bits) /
                                    static_cast<std::uint64_t>((grid.last - grid.first).count()));
}

Nanometers BedMesh::height_at(const units::PerAxis<units::Position>& place) const {
  std::array<std::size_t, 2> index;
  std::array<std::uint32_t, 2> part;
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const std::uint32_t here = cells(axis, place[axis]);
    // The last line belongs to the cell before it.
    index[axis] = std::min<std::size_t>(here >> fraction_bits, axes_[axis].points - 2u);
    part[axis] = here - (static_cast<std::uint32_t>(index[axis]) << fraction_bits);
  }
  const auto along_x = [&](std::size_t row) {
    return between(heights_[row][index[0]], heights_[row][index[0] + 1], part[0]);
  };
  return Nanometers(between(along_x(index[1]), along_x(index[1] + 1), part[1]));
}

Nanometers BedMesh::faded(Nanometers height, const units::Position& at) const {
  const Nanometers end = fade_height();
  const Nanometers here = at.nearest();
  if (end == Nanometers() || here <= Nanometers()) return height;
  if (here >= end) return {};
  return Nanometers(divided(height.count() * (end - here).count(), end.count()));
}

// With the nozzle at z + height * (end - z) / end where it fades.
units::Position BedMesh::uncorrected_z(const units::PerAxis<units::Position>& nozzle) const {
  const Nanometers height = height_at(nozzle);
  const Nanometers end = fade_height();
  const units::Position unfaded = nozzle[z] - height;
  if (end == Nanometers() || unfaded.nearest() <= Nanometers()) return unfaded;
  if (nozzle[z].nearest() >= end) return nozzle[z];
  return Nanometers(divided(unfaded.nearest().count() * end.count(), (end - height).count()));
}

}  // namespace motion
