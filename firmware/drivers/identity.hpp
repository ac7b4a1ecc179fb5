// SPDX-License-Identifier: Apache-2.0
// Version and sizes of the chip, so that one firmware image serves every build of it.
#pragma once

#include <cstdint>
#include <optional>

#include "units/quantity.hpp"

namespace drivers {

struct Version {
  std::uint16_t major{};
  std::uint8_t minor{};
  std::uint8_t patch{};

  constexpr bool operator==(const Version&) const = default;
};

struct Identity {
  Version version;
  units::Hertz clock;
  std::uint32_t memory_bytes{};
  std::uint8_t axes{};
  std::uint16_t queue_depth{};  // segments that the step generator's queue holds
  std::uint8_t sensors{};  // channels of the temperature converter
  std::uint8_t heaters{};  // channels of the heater control
};

// Nothing where the magic word is not there: then this is no StepFabric chip, and no other register
// of the map may be trusted.
std::optional<Identity> read_identity();

}  // namespace drivers
