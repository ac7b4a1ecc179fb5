// SPDX-License-Identifier: Apache-2.0
// The lift of G10: what soft limits make of it, and what is left of it after homing and stops.
#include "tests/application/retraction.hpp"

namespace application_test {
namespace {

class LiftedZ : public Retraction {};

// Otherwise the nozzle would be below the bed after G11, or G11 refused and Z left lifted.
TEST_F(LiftedZ, keeps_the_lowered_nozzle_within_the_travel) {
  execute({"M207 S2 Z1.5", "G10"});
  talk(R"(
    -> G0 Z-1
    <- echo:Move beyond the end of Z (0.00 to 110.00), not executed: "G0 Z-1"
    <- ok
    -> G2 X30 I5 Z-0.01 F600
    <- echo:Move beyond the end of Z (0.00 to 110.00), not executed: "G2 X30 I5 Z-0.01 F600"
    <- ok
  )");
  execute({"G1 Z0 F600"});
  expect(18, 1.5);
  execute({"G11"});
  expect(20, 0);
}

TEST_F(LiftedZ, counts_no_lift_that_a_jump_has_made_void) {
  execute({"M207 S2 Z1.5", "G10", "G28 Z", "G1 Z0.5 F600"});
  expect(18, 0.5);
}

// Where Z stands below its travel, as after lines without limits: G11 leads there again.
TEST_F(LiftedZ, is_recovered_below_the_travel_where_it_began) {
  execute({"M211 S0", "G1 Z-0.5 F600", "M211 S1", "M207 S2 Z1.5", "G10", "G11"});
  expect(20, -0.5);
}

// By what has been set, and not by where Z is: baby steps and G92 may add up to the lift.
TEST_F(LiftedZ, leaves_a_z_alone_that_was_homed_at_any_shift) {
  execute({"G92 Z6.5", "M207 Z1.5", "G10", "G28 Z", "G11", "G1 Z1 F600"});
  expect(20, 1);
  execute({"M290 Z-0.5", "M207 Z0.5", "G10", "G28 Z", "G11", "G1 Z2"});
  expect(20, 2);
}

TEST_F(LiftedZ, gives_the_lift_back_after_a_stop_however_z_is_shifted_meanwhile) {
  execute({"M207 S2 Z1.5", "G10", "M400", "M290 Z0.05", "M400", "M410", "G11", "G1 Z5 F600"});
  expect(20, 5.05);
  execute({"M290 Z-0.05", "G10", "M400", "M206 Z0.2", "G28 X", "G11", "G1 Z5.2 F600"});
  expect(20, 5);
}

// A homed Z is where it says it is: lowering it would drive the nozzle into the bed.
TEST_F(LiftedZ, does_not_lower_z_after_homing_it) {
  execute({"M207 S2 Z1", "G10", "G28 Z", "G11", "G1 Z5 F600"});
  expect(20, 5);
}

// Wherever a stop has ended the moves: the host's coordinate of Z is that of the place again.
TEST_F(LiftedZ, does_not_lower_z_after_a_stop) {
  execute({"M207 S2 Z1", "G10"});
  talk("-> G1 X150 F600\n<- ok\n");
  printer.run(1.0);
  execute({"M410", "G11"});
  EXPECT_GT(printer.mm(x), 11);
  EXPECT_LT(printer.mm(x), 140);
  expect(20, 6);
  execute({"G1 Z5 F600"});
  expect(20, 5);
}

}  // namespace
}  // namespace application_test
