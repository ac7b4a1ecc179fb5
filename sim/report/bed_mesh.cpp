// SPDX-License-Identifier: Apache-2.0
// Between four points, and less of it with Z.
#include "sim/report/bed_mesh.hpp"

#include <algorithm>

namespace report {

BedMesh::BedMesh(const std::array<MeshLines, 2>& lines, double fade_height_mm)
    : lines_(lines), heights_(lines[0].points * lines[1].points), fade_height_(fade_height_mm) {}

bool BedMesh::complete() const {
  return !heights_.empty() &&
         std::ranges::all_of(heights_, [](const auto& height) { return height.has_value(); });
}

double BedMesh::height_at(double x, double y) const {
  if (!complete()) return 0;
  const std::array place{x, y};
  std::array<std::size_t, 2> cell{};
  std::array<double, 2> part{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const MeshLines& lines = lines_[axis];
    const double span = (lines.last - lines.first) / static_cast<double>(lines.points - 1);
    const double within = (std::clamp(place[axis], lines.first, lines.last) - lines.first) / span;
    cell[axis] = std::min(static_cast<std::size_t>(within), lines.points - 2);
    part[axis] = within - static_cast<double>(cell[axis]);
  }
  const auto corner = [&](std::size_t right, std::size_t behind) {
    return *heights_[(cell[1] + behind) * lines_[0].points + cell[0] + right];
  };
  const double front = (1 - part[0]) * corner(0, 0) + part[0] * corner(1, 0);
  const double back = (1 - part[0]) * corner(0, 1) + part[0] * corner(1, 1);
  return (1 - part[1]) * front + part[1] * back;
}

double BedMesh::correction(double x, double y, double z) const {
  const double height = height_at(x, y);
  if (fade_height_ == 0) return height;
  return height * std::clamp(1 - z / fade_height_, 0.0, 1.0);
}

// Above the bed and below the end of fading nozzle_z = z + height * (1 - z / fade_height).
double BedMesh::uncorrected_z(double x, double y, double nozzle_z) const {
  const double height = height_at(x, y);
  if (fade_height_ == 0 || nozzle_z <= height) return nozzle_z - height;
  if (nozzle_z >= fade_height_) return nozzle_z;
  return (nozzle_z - height) / (1 - height / fade_height_);
}

}  // namespace report
