// SPDX-License-Identifier: Apache-2.0
// Pages for people, from the tables that the firmware is compiled from.
#pragma once

#include <string>

namespace firmware_pages {

std::string gcodes();
std::string tasks();

}  // namespace firmware_pages
