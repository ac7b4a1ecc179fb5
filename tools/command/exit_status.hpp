// SPDX-License-Identifier: Apache-2.0
// What the command's exit statuses mean.
#pragma once

namespace command {

inline constexpr int success = 0;
inline constexpr int failure = 1;  // the job was done and its outcome is bad
inline constexpr int bad_input = 2;  // bad usage, or a file that is missing or invalid
inline constexpr int interrupted = 130;  // Ctrl-C

// `run` ends with the status of its program, 1 to 123, so its own failures lie above them, where
// coreutils' `timeout` has them too.
inline constexpr int highest_program_status = 123;  // or higher: the output says which
inline constexpr int time_out = 124;  // the program did not end in time
inline constexpr int not_run = 125;  // bad usage, or a file that is missing or no such program

}  // namespace command
