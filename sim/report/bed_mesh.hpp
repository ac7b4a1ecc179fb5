// SPDX-License-Identifier: Apache-2.0
// The heights that lines follow above an uneven bed, in floating point: written from what G29, M420
// and M421 are documented to do, apart from the firmware.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace report {

// Where the mesh has points on X or Y: equally far apart. Millimetres of the machine.
struct MeshLines {
  double first{}, last{};
  std::size_t points{};

  double at(std::size_t index) const {
    return first + (last - first) * static_cast<double>(index) / static_cast<double>(points - 1);
  }
};

class BedMesh {
 public:
  BedMesh() = default;
  // No height is known.
  BedMesh(const std::array<MeshLines, 2>& lines, double fade_height_mm);

  const std::array<MeshLines, 2>& lines() const { return lines_; }
  std::optional<double>& height(std::size_t column, std::size_t row) {
    return heights_.at(row * lines_[0].points + column);
  }
  bool complete() const;
  // From there on lines are level; 0: they never are.
  double fade_height_mm() const { return fade_height_; }
  void set_fade_height(double height_mm) { fade_height_ = height_mm; }

  // Bilinear within a cell, beyond the mesh that of its border. Where the mesh is not complete: 0.
  double height_at(double x, double y) const;
  // How much higher the nozzle is than Z says.
  double correction(double x, double y, double z) const;
  // The Z that says so where the nozzle is.
  double uncorrected_z(double x, double y, double nozzle_z) const;

 private:
  std::array<MeshLines, 2> lines_{};
  std::vector<std::optional<double>> heights_;  // row by row
  double fade_height_{};
};

}  // namespace report
