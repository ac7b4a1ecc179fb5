// SPDX-License-Identifier: Apache-2.0
// Looks for the loader at its place (boot_loader/start.S) and jumps into it. Only in the image.
#include "platform/boot_loader.hpp"

#include <cstdint>

extern "C" const volatile std::uint32_t _boot_loader[];

namespace platform {

namespace {

// In words.
constexpr std::size_t after_reset = 0, request = 1, magic_place = 2;

template <std::size_t entry>
bool enter() {
  constexpr std::uint32_t magic = 0x6C4F6642;
  if (_boot_loader[magic_place] != magic) return false;
  asm volatile("csrw mie, zero");
  asm volatile("jr %0" ::"r"(&_boot_loader[entry]));
  __builtin_unreachable();
}

}  // namespace

bool enter_boot_loader() { return enter<request>(); }

bool restart() { return enter<after_reset>(); }

}  // namespace platform
