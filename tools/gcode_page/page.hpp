// SPDX-License-Identifier: Apache-2.0
// The page of G-codes, for people: from the table that the firmware is compiled from.
#pragma once

#include <string>

namespace gcode_page {

std::string page();

}  // namespace gcode_page
