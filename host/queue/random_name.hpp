// SPDX-License-Identifier: Apache-2.0
// Names that nobody else chooses.
#pragma once

#include <string>

namespace queue {

// 24 hexadecimal digits. Throws std::system_error.
std::string random_name();

}  // namespace queue
