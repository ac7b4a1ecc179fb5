// SPDX-License-Identifier: Apache-2.0
// The time that rows have.
#pragma once

#include <chrono>
#include <cstdint>

namespace queue {

// Since 1970, in milliseconds.
inline std::int64_t now_ms() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace queue
