// SPDX-License-Identifier: Apache-2.0
// Roots of whole numbers.
#pragma once

#include <cstdint>

namespace motion {

// The whole number nearest to the root; 0 <= square < 2^62.
std::uint32_t nearest_root(std::uint64_t square);

}  // namespace motion
