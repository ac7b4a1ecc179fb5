// SPDX-License-Identifier: Apache-2.0
// Which axes are homed, as far as lines that were sent can show it.
#include "host/feeder/homed_axes.hpp"

#include <gtest/gtest.h>

namespace {

using feeder::HomedAxes;

std::string axes_after(std::initializer_list<std::string_view> lines) {
  HomedAxes homed;
  for (const std::string_view line : lines) homed.sent(line);
  return homed.axes();
}

TEST(homed_axes, are_all_or_those_that_are_named) {
  EXPECT_EQ(axes_after({}), "");
  EXPECT_EQ(axes_after({"G28"}), "xyz");
  EXPECT_EQ(axes_after({"g28 y"}), "y");
  EXPECT_EQ(axes_after({"G28 Z0", "G28X"}), "xz");
  EXPECT_EQ(axes_after({"G28 X ; Y too"}), "x");
  EXPECT_EQ(axes_after({"G28 (X)"}), "xyz");
}

TEST(homed_axes, are_homed_by_nothing_else) {
  EXPECT_EQ(axes_after({"G1 X5", "G280 X", "G28.1 X", "M28 X", "M117 G28"}), "");
}

TEST(homed_axes, are_lost_with_the_motors) {
  EXPECT_EQ(axes_after({"G28", "M84"}), "");
  EXPECT_EQ(axes_after({"G28", "m18 X"}), "");
  EXPECT_EQ(axes_after({"G28", "M112"}), "");
  EXPECT_EQ(axes_after({"G28", "M840"}), "xyz");
}

}  // namespace
