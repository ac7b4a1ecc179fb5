// SPDX-License-Identifier: Apache-2.0
// The heaters, their sensors and the converter of a machine description.
#pragma once

#include <cstdint>

#include "application/machine_description.hpp"
#include "machine_generator/reader.hpp"

namespace machine_generator {

// What has been checked to be in the quantity's range.
template <class Quantity>
Quantity quantity(std::int64_t value) {
  return Quantity(static_cast<typename Quantity::Representation>(value));
}

// Reads [hotend], [bed], [thermistors] and [temperature_converter].
void read_heaters(Reader& root, application::MachineDescription& machine);

}  // namespace machine_generator
