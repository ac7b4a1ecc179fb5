// SPDX-License-Identifier: Apache-2.0
// Finds a device by its name.
#include "tools/synthesis/device.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace synthesis {

const Device& device_named(std::string_view name) {
  const auto* found = std::ranges::find(devices, name, &Device::name);
  if (found == devices.end()) throw std::out_of_range("no device " + std::string(name));
  return *found;
}

}  // namespace synthesis
