// SPDX-License-Identifier: Apache-2.0
// The files of a feeder in its folder.
#pragma once

namespace feeder {

inline constexpr const char* socket_name = "feeder.socket";
inline constexpr const char* journal_name = "journal.json";

}  // namespace feeder
