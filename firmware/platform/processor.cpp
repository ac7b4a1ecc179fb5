// SPDX-License-Identifier: Apache-2.0
// The processor's own instructions behind `platform/processor.hpp`. Only in the image.
#include "platform/processor.hpp"

extern "C" const std::uint32_t _stack_bottom[];

namespace platform {
namespace {

constexpr std::uint32_t stack_paint = 0xA5A5A5A5;  // as start.S paints it

}  // namespace

std::uint32_t clocks() {
  std::uint32_t value;
  asm volatile("csrr %0, mcycle" : "=r"(value));
  return value;
}

std::uint32_t instructions() {
  std::uint32_t value;
  asm volatile("csrr %0, minstret" : "=r"(value));
  return value;
}

bool stack_is_intact() {
  return *static_cast<const volatile std::uint32_t*>(_stack_bottom) == stack_paint;
}

}  // namespace platform
