// SPDX-License-Identifier: Apache-2.0
// The room in which the simulated printer stands.
#pragma once

namespace machine {

inline constexpr double ambient_celsius = 22.0;

}  // namespace machine
