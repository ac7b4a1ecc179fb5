// SPDX-License-Identifier: Apache-2.0
// What is known of a printer's bed, as the database has it.
#pragma once

#include <cstdint>

namespace queue {

// `taken`: clear when its job was started; take_back() makes it clear again.
enum class Bed : std::int64_t { not_clear = 0, clear = 1, taken = 2 };

}  // namespace queue
