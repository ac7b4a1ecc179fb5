// SPDX-License-Identifier: Apache-2.0
// Names that are chosen once.
#pragma once

#include <string>

namespace queue {

// 24 hexadecimal digits. Throws std::system_error.
std::string random_name();

}  // namespace queue
