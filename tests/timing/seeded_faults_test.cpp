// SPDX-License-Identifier: Apache-2.0
// Each fault of the list is found by its check, which finds nothing without the fault.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/timing/seeded_faults.hpp"

namespace timing {
namespace {

std::vector<Fault> faults() {
  std::vector<Fault> all;
  for (const auto& list : {wrong_costs(), wrong_flow(), wrong_facts(), wrong_proofs()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

TEST(SeededFaults, none_no_check_finds_any) {
  const Tool tool;
  for (const Check check : {cost_sum, measured_time, measured_span, refusal, certificate,
                            proved_time, second_opinion}) {
    EXPECT_EQ(check(tool), "");
  }
  EXPECT_EQ(bound_of(tool.program, tool.costs), tool.measured.clocks) << "no clock to spare";
  EXPECT_EQ(proved_bound(tool.proof.rows, tool.proof.prices), tool.measured.clocks);
}

TEST(SeededFaults, are_found_each_by_its_check) {
  const Tool right;
  for (const Fault& fault : faults()) {
    Tool tool = right;
    fault.seed(tool);
    const std::string found = fault.finds(tool);
    EXPECT_NE(found, "") << fault.kind << ": " << fault.name;
    fmt::print("{}: {}: {}\n", fault.kind, fault.name, found);
  }
}

TEST(SeededFaults, are_many_of_many_kinds) {
  std::set<std::string> kinds;
  std::set<std::pair<std::string, std::string>> names;
  for (const Fault& fault : faults()) {
    kinds.insert(fault.kind);
    EXPECT_TRUE(names.emplace(fault.kind, fault.name).second) << fault.name << " twice";
  }
  EXPECT_GE(kinds.size(), 15U);
  EXPECT_GE(names.size() - wrong_costs().size(), 20U) << "besides wrong costs";
}

}  // namespace
}  // namespace timing
