// SPDX-License-Identifier: Apache-2.0
// The identity block's registers.
#include "drivers/identity.hpp"

#include "platform/bus.hpp"
#include "registers/identity_registers.hpp"

namespace drivers {

namespace identity_registers = registers::identity;

std::optional<Identity> read_identity() {
  using identity_registers::Magic;
  if (platform::read<Magic>().word != Magic::Word::stepfabric) return std::nullopt;
  const auto version = platform::read<identity_registers::Version>();
  const auto motion = platform::read<identity_registers::Motion>();
  const auto thermal = platform::read<identity_registers::Thermal>();
  return Identity{
      .version =
          {
              .major = static_cast<std::uint16_t>(version.major),
              .minor = static_cast<std::uint8_t>(version.minor),
              .patch = static_cast<std::uint8_t>(version.patch),
          },
      .clock = units::Hertz(platform::read<identity_registers::Clock>().frequency_hz),
      .memory_bytes = platform::read<identity_registers::Memory>().size_bytes,
      .axes = static_cast<std::uint8_t>(motion.axes),
      .queue_depth = static_cast<std::uint16_t>(motion.queue_depth),
      .sensors = static_cast<std::uint8_t>(thermal.sensors),
      .heaters = static_cast<std::uint8_t>(thermal.heaters),
  };
}

}  // namespace drivers
