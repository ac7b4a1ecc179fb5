// SPDX-License-Identifier: Apache-2.0
// Which G-codes move or heat something, or decide where moves go: those a print cannot do without.
#pragma once

#include <string_view>

namespace report {

// Of the whole line, whatever the firmware makes of it. Macros of other firmwares (START_PRINT
// BED=60), coordinates without a code (X10 Y5) and unknown G-codes count as moves; unknown M-codes
// do not.
bool moves_or_heats(std::string_view command);

}  // namespace report
