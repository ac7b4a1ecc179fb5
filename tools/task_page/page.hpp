// SPDX-License-Identifier: Apache-2.0
// The page of tasks, for people: from the table that the firmware is compiled from.
#pragma once

#include <string>

namespace task_page {

std::string page();

}  // namespace task_page
