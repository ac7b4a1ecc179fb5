// SPDX-License-Identifier: Apache-2.0
// Defines platform::bus_read and bus_write for host tests: they go to the peripherals
// that live now.
#include "tests/drivers/verilated_bus.hpp"

#include <map>

#include "platform/bus.hpp"

namespace tests {
namespace {

constexpr std::uint32_t page_mask = 0xFFFF'F000u;

std::map<std::uint32_t, ClockedPeripheral*>& peripherals() {
  static std::map<std::uint32_t, ClockedPeripheral*> by_base;
  return by_base;
}

ClockedPeripheral& peripheral_at(std::uint32_t address) {
  const auto found = peripherals().find(address & page_mask);
  if (found == peripherals().end()) {
    throw BusError("no peripheral at address " + std::to_string(address));
  }
  return *found->second;
}

}  // namespace

ClockedPeripheral::ClockedPeripheral(std::uint32_t base) {
  if (!peripherals().emplace(base & page_mask, this).second) {
    throw std::logic_error("two peripherals at one address");
  }
}

ClockedPeripheral::~ClockedPeripheral() {
  std::erase_if(peripherals(), [this](const auto& entry) { return entry.second == this; });
}

}  // namespace tests

namespace platform {

std::uint32_t bus_read(std::uint32_t address) {
  return tests::peripheral_at(address).read(address);
}

void bus_write(std::uint32_t address, std::uint32_t value) {
  tests::peripheral_at(address).write(address, value);
}

}  // namespace platform
