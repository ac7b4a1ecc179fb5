// SPDX-License-Identifier: Apache-2.0
// A small picture of a path, seen from the front, the right and above.
#pragma once

#include <string>

#include "tools/planning/path.hpp"

namespace planning {

inline constexpr int picture_pixels = 160;  // its width and height

// PNG with a transparent background. Empty where nothing is extruded.
std::string picture_of(const Path& path);

}  // namespace planning
