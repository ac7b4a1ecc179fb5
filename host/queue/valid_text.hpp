// SPDX-License-Identifier: Apache-2.0
// Text as PostgreSQL takes it.
#pragma once

#include <string>
#include <string_view>

namespace queue {

// UTF-8 without NUL: U+FFFD stands for each byte that belongs to no character.
std::string valid_text(std::string_view text);

}  // namespace queue
