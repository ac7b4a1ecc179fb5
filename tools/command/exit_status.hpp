// SPDX-License-Identifier: Apache-2.0
// What the command's exit statuses mean.
#pragma once

namespace command {

inline constexpr int success = 0;
inline constexpr int failure = 1;  // the job was done and its outcome is bad
inline constexpr int bad_input = 2;  // bad usage, or a file that is missing or no good
inline constexpr int time_out =
    124;  // a program did not end in time, as coreutils' timeout says it
inline constexpr int interrupted = 130;  // Ctrl-C

}  // namespace command
