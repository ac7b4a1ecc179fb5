// SPDX-License-Identifier: Apache-2.0
// The heights of the bed at the points of a grid, and between them: bilinear in each cell, beyond
// the grid that of its border. A height counts in full at the bed and fades linearly with Z.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

// Where the grid's lines lie on X or Y: `points` of them, equally far apart from `first` to `last`.
struct MeshAxis {
  units::Nanometers first{};
  units::Nanometers last{};  // beyond the first, by less than 2 m
  std::uint8_t points{};  // 2 .. BedMesh::most_points

  // Rounded to nearest, halves away from the first.
  units::Nanometers line(std::size_t index) const {
    const std::int64_t parts = points - 1;
    return first +
           units::Nanometers(
               ((last - first).count() * static_cast<std::int64_t>(index) + parts / 2) / parts);
  }
};

// What the machine description says of it.
struct MeshSettings {
  std::array<MeshAxis, 2> axes{};  // X, Y
  units::Nanometers fade_height{};  // 0: it does not fade
};

class BedMesh {
 public:
  static constexpr std::size_t most_points = 15;
  // Of a point; a higher one is a mistake.
  static constexpr units::Nanometers most_height{10'000'000};
  static constexpr units::Nanometers most_fade_height{1'000'000'000};
  using Height = std::int32_t;  // nm

  static constexpr bool may_be(units::Nanometers height) {
    return height <= most_height && -height <= most_height;
  }

  // Forgets all heights.
  void set_axes(const std::array<MeshAxis, 2>& axes);
  std::size_t points(std::size_t axis) const { return axes_[axis].points; }
  // Of the grid on X or Y, in rising order.
  std::span<const units::Nanometers> lines(std::size_t axis) const {
    return {lines_[axis].data(), axes_[axis].points};
  }
  units::Nanometers line(std::size_t axis, std::size_t index) const { return lines_[axis][index]; }

  // Nothing where it is not known.
  std::optional<units::Nanometers> height(std::size_t column, std::size_t row) const;
  // False, and nothing done, where it is too high or too low.
  bool set_height(std::size_t column, std::size_t row, units::Nanometers height);
  // All heights are known.
  bool complete() const;
  // The largest of either sign.
  units::Nanometers largest() const;

  // 0 to most_fade_height; 0: it does not fade.
  void set_fade_height(units::Nanometers height);
  units::Nanometers fade_height() const { return fade_lines_[1]; }
  // Where fading begins and ends.
  std::span<const units::Nanometers> fade_lines() const {
    return {fade_lines_.data(), fade_height() == units::Nanometers() ? 0 : fade_lines_.size()};
  }
  // Higher than so, the nozzle rises with Z everywhere, at half of Z's speed at least.
  bool fades_slowly() const {
    return fade_height() == units::Nanometers() || fade_height() >= largest() * 2;
  }

  // All heights must be known. To 5 nm:
  units::Nanometers height_at(const units::PerAxis<units::Position>& place) const;
  // What of this height counts at this Z.
  units::Nanometers faded(units::Nanometers height, const units::Position& z) const;
  // How much higher the nozzle is to be than Z says.
  units::Nanometers correction(const units::PerAxis<units::Position>& place) const {
    return faded(height_at(place), place[units::index_of(units::Axis::z)]);
  }
  // The Z that says so where the nozzle is.
  units::Position uncorrected_z(const units::PerAxis<units::Position>& nozzle) const;

 private:
  static constexpr Height unknown = INT32_MIN;
  // In 2^-24 of a cell, from the first line; within the grid.
  std::uint32_t cells(std::size_t axis, const units::Position& place) const;

  std::array<MeshAxis, 2> axes_{};
  std::array<std::array<units::Nanometers, most_points>, 2> lines_{};
  std::array<std::array<Height, most_points>, most_points> heights_{};  // row by row
  std::array<units::Nanometers, 2> fade_lines_{};
};

}  // namespace motion
