// SPDX-License-Identifier: Apache-2.0
// The names by which the compiler calls for copies. They take the place of its
// library's, which go byte by byte, and know nothing of registers that an image keeps
// for itself (software_stepping/tick.S).
#include "platform/memory.hpp"

extern "C" {

void* memcpy(void* to, const void* from, std::size_t bytes) {
  return platform::copy(to, from, bytes);
}

void* memmove(void* to, const void* from, std::size_t bytes) {
  return platform::move(to, from, bytes);
}

void* memset(void* begin, int byte, std::size_t bytes) {
  return platform::fill(begin, static_cast<unsigned char>(byte), bytes);
}

}  // extern "C"
