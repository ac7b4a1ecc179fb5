// SPDX-License-Identifier: Apache-2.0
// The identity's driver against the identity block.
#include "drivers/identity.hpp"

#include <gtest/gtest.h>

#include <Videntity.h>
#include <string>

#include "registers/identity_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

TEST(Identity, reports_what_the_chip_was_built_with) {
  tests::VerilatedPeripheral<Videntity> chip{registers::identity::base};
  chip->clock_frequency_hz = 12'345'678;
  chip.clock();
  const auto identity = drivers::read_identity();
  ASSERT_TRUE(identity.has_value());
  EXPECT_EQ(identity->clock, units::Hertz(12'345'678));
  EXPECT_EQ(identity->memory_bytes, 65'536u);
  EXPECT_EQ(identity->axes, 5);
  EXPECT_EQ(identity->queue_depth, 16);
  EXPECT_EQ(identity->sensors, 2);
  EXPECT_EQ(identity->heaters, 2);
}

TEST(Identity, has_the_version_of_the_project) {
  tests::VerilatedPeripheral<Videntity> chip{registers::identity::base};
  const auto identity = drivers::read_identity();
  ASSERT_TRUE(identity.has_value());
  const drivers::Version version = identity->version;
  EXPECT_EQ(std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
                std::to_string(version.patch),
            PROJECT_VERSION);
}

TEST(Identity, cannot_be_written) {
  tests::VerilatedPeripheral<Videntity> chip{registers::identity::base};
  EXPECT_THROW(chip.write(registers::identity::Magic::address, 0), tests::BusError);
}

// A chip of another design, whose registers mean something else.
class ForeignChip : public tests::ClockedPeripheral {
 public:
  ForeignChip() : ClockedPeripheral(registers::identity::base) {}
  std::uint32_t read(std::uint32_t) override { return 0x12345678; }
  void write(std::uint32_t, std::uint32_t) override {}
};

TEST(Identity, is_absent_on_a_foreign_chip) {
  const ForeignChip chip;
  EXPECT_FALSE(drivers::read_identity().has_value());
}

}  // namespace
