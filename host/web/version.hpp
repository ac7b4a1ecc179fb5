// SPDX-License-Identifier: Apache-2.0
// The versions that clients are answered.
#pragma once

namespace web {

inline constexpr const char* stepfabric_version = STEPFABRIC_VERSION;
// Of the API that is followed.
inline constexpr const char* octoprint_version = "1.9.0";

}  // namespace web
