// SPDX-License-Identifier: Apache-2.0
// Every control that the page has shown in the tests was used in one of them.
#include <cstdio>

#include "tests/host/browser/page_fixture.hpp"

namespace browser_test {
namespace {

class EveryControl : public testing::Environment {
  void TearDown() override {
    if (GTEST_FLAG_GET(filter) != "*") {
      return;  // a part of the tests uses a part of them
    }
    std::printf("controls: %zu kinds seen, %zu used\n", controls().seen.size(),
                controls().used.size());
    EXPECT_THAT(controls().used, testing::IsSupersetOf(controls().seen));
    EXPECT_GT(controls().seen.size(), 20u);
  }
};

const auto* const every_control = testing::AddGlobalTestEnvironment(new EveryControl);

}  // namespace
}  // namespace browser_test
