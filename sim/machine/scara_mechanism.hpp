// SPDX-License-Identifier: Apache-2.0
// A serial SCARA: two arms in the horizontal plane, whose motors turn them against the frame.
#pragma once

#include "sim/machine/mechanism.hpp"

namespace machine {

// mm and degrees; as the machine description has them.
struct ScaraProperties {
  double proximal{}, distal{};
  bool elbow_left{};
  std::array<double, 2> shoulder{}, end_stop{}, home{};
  double height{};
};

std::shared_ptr<const Mechanism> scara_mechanism(const ScaraProperties& properties);

}  // namespace machine
