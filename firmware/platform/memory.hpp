// SPDX-License-Identifier: Apache-2.0
// Copying and filling of memory, a word at a time where both ends lie on words.
#pragma once

#include <cstddef>

namespace platform {

// All return where they write to. The pieces do not overlap.
void* copy(void* to, const void* from, std::size_t bytes);
// They may overlap.
void* move(void* to, const void* from, std::size_t bytes);
void* fill(void* begin, unsigned char byte, std::size_t bytes);

}  // namespace platform
