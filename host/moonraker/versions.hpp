// SPDX-License-Identifier: Apache-2.0
// The versions that clients are answered.
#pragma once

#include <array>

namespace moonraker {

inline constexpr const char* stepfabric_version = STEPFABRIC_VERSION;
// Of the API that is followed: front ends ask for a lowest one.
inline constexpr const char* moonraker_version = "v0.9.3-0-stepfabric";
inline constexpr std::array api_version{1, 5, 0};
inline constexpr const char* api_version_text = "1.5.0";

}  // namespace moonraker
