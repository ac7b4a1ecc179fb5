// SPDX-License-Identifier: Apache-2.0
// Calculations of the interface board's values.
#include "tools/wiring/formula.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace wiring {
namespace {

TEST(Formula, is_calculated_in_the_usual_order) {
  const Numbers numbers{{"volts", 3.3}, {"ohms_1", 1'500}};
  EXPECT_DOUBLE_EQ(value_of("2 + 3 * 4 - 6 / 2", numbers), 11);
  EXPECT_DOUBLE_EQ(value_of("(2 + 3) * 4", numbers), 20);
  EXPECT_DOUBLE_EQ(value_of("volts * ohms_1 / (ohms_1 + 1.5e3)", numbers), 1.65);
  EXPECT_NEAR(value_of("ln(exp(2)) + ln(volts / 1.65)", numbers), 2.6931471806, 1e-9);
}

TEST(Formula, that_cannot_be_calculated_is_refused) {
  for (const char* formula : {"", "1 +", "(1", "1)", "1 2", "ohms", "ln 2", "1 / 0", "2 * * 3"}) {
    EXPECT_THROW(value_of(formula, {}), std::runtime_error) << formula;
  }
}

TEST(Number, is_shown_with_its_unit) {
  EXPECT_EQ(shown(4'700, "Ω"), "4.7 kΩ");
  EXPECT_EQ(shown(470, "Ω"), "470 Ω");
  EXPECT_EQ(shown(68e-9, "F"), "68 nF");
  EXPECT_EQ(shown(1'000e-6, "F"), "1000 µF");
  EXPECT_EQ(shown(0.5756, "V"), "576 mV");
  EXPECT_EQ(shown(999.7, "Ω"), "1 kΩ");
  EXPECT_EQ(shown(359'123.4, ""), "359123");
  EXPECT_EQ(shown(1.5, ""), "1.5");
  EXPECT_EQ(shown(0, "V"), "0");
}

}  // namespace
}  // namespace wiring
