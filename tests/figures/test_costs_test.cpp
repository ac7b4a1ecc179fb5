// SPDX-License-Identifier: Apache-2.0
// The most expensive tests are found in what ctest writes.
#include "tools/figures/test_costs.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace {

using testing::HasSubstr;
using testing::Not;

const char* const junit = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="(empty)" tests="4" failures="1" disabled="1" skipped="0">
	<testcase name="quick" classname="quick" time="1.5" status="run">
		<system-out>it says &lt;testcase name="none" time="99" status="run"&gt;</system-out>
	</testcase>
	<testcase name="slow" classname="slow" time="120.25" status="run">
	</testcase>
	<testcase name="wrong" classname="wrong" time="3" status="fail">
		<failure message=""/>
	</testcase>
	<testcase name="absent" classname="absent" time="0" status="disabled">
	</testcase>
</testsuite>
)xml";

TEST(test_costs, are_those_of_all_tests_that_were_run_in_falling_order) {
  const auto costs = figures::test_costs_of(junit);
  ASSERT_EQ(costs.size(), 3u);
  EXPECT_EQ(costs[0].name, "slow");
  EXPECT_EQ(costs[0].seconds, 120.25);
  EXPECT_EQ(costs[1].name, "wrong");
  EXPECT_EQ(costs[2].name, "quick");
  EXPECT_THROW(figures::test_costs_of("<testsuite></testsuite>"), std::runtime_error);
}

TEST(test_costs, are_shown_with_their_share_of_all) {
  const std::string page = figures::page_of(figures::test_costs_of(junit), 2);
  EXPECT_THAT(page, HasSubstr("the 2 most expensive of 3 tests, which take\n125 s"));
  EXPECT_THAT(page, HasSubstr("| `slow` | 120 | 96 % |\n| `wrong` | 3 | 2 % |\n"));
  EXPECT_THAT(page, Not(HasSubstr("quick")));
  EXPECT_THAT(figures::json_of(figures::test_costs_of(junit)), HasSubstr("\"seconds\": 124.75"));
}

}  // namespace
