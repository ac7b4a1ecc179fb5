// SPDX-License-Identifier: Apache-2.0
// The names by which the compiler calls for copies. They take the place of its library's, which go
// byte by byte.
#include "platform/memory.hpp"

extern "C" {

void* memcpy(void* to, const void* from, std::size_t bytes) {
  platform::copy(to, from, bytes);
  return to;
}

void* memset(void* begin, int byte, std::size_t bytes) {
  platform::fill(begin, static_cast<unsigned char>(byte), bytes);
  return begin;
}

}  // extern "C"
