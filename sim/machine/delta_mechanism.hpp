// SPDX-License-Identifier: Apache-2.0
// A linear delta: three carriages on towers carry the tool by rods.
#pragma once

#include "sim/machine/mechanism.hpp"

namespace machine {

// mm; as the machine description has them.
struct DeltaProperties {
  double rod{}, radius{}, height{}, printable_radius{};
  std::array<double, 3> end_stop_offset{};
};

std::shared_ptr<const Mechanism> delta_mechanism(const DeltaProperties& properties);

}  // namespace machine
