// SPDX-License-Identifier: Apache-2.0
// The bus of the chip: one volatile access per word. Only in the image, never in host programs.
#include "platform/bus.hpp"

namespace platform {

std::uint32_t bus_read(std::uint32_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

void bus_write(std::uint32_t address, std::uint32_t value) {
  *reinterpret_cast<volatile std::uint32_t*>(address) = value;
}

}  // namespace platform
