// SPDX-License-Identifier: Apache-2.0
// The file of a path: a head in JSON, then the points, so that a reader takes one layer alone.
//
//   8 bytes   "SFPATH1\n"
//   4 bytes   length of the head, little-endian as all numbers
//   head      {"unit_mm": …, "steps_per_mm": [X, Y, Z], "bounds_mm": [X, Y, X, Y] of what extrudes,
//             "layers": [[Z in mm, number of points, command of its first line], …]}
//   points    of 8 bytes, layer after layer: X and Y in units (16 bits each, signed), then 32 bits:
//             twice the command that leads there, and 1 where it extrudes on the way
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "tools/planning/path.hpp"

namespace planning {

inline constexpr std::size_t path_point_bytes = 8;

std::string path_file_of(const Path& path);

// The head, as it is in the file. Throw std::runtime_error where it is no such file.
std::string read_path_head(const std::filesystem::path& file);
// The points of a layer, counted from 0, as they are in the file; nothing where it has none such.
std::optional<std::string> read_path_layer(const std::filesystem::path& file, std::size_t layer);

}  // namespace planning
