// SPDX-License-Identifier: Apache-2.0
// The texts of sim/report/page, which the build embeds into the program.
#pragma once

namespace report {

extern const char* const page_style;
extern const char* const page_script;

}  // namespace report
