// SPDX-License-Identifier: Apache-2.0
// Pictures as PNG (ISO/IEC 15948).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace planning {

struct Pixel {
  std::uint8_t red{}, green{}, blue{}, alpha{};
};

// Row after row from the top. Throws std::logic_error where the pixels are no such rectangle.
std::string png_of(const std::vector<Pixel>& pixels, std::uint32_t width, std::uint32_t height);

}  // namespace planning
