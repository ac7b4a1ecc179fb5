// SPDX-License-Identifier: Apache-2.0
// What this process and its machine use, from /proc.
#pragma once

#include <nlohmann/json.hpp>

namespace moonraker {

// As notify_proc_stat_update has it; `connections`: open WebSockets. Processor time is that since
// the last call with the same state.
struct ProcessorTime {
  double process = 0, at = 0, busy = 0, all = 0;
};
nlohmann::json process_stats(ProcessorTime& last, std::size_t connections);
nlohmann::json system_info();

}  // namespace moonraker
