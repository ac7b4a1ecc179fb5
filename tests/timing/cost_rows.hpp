// SPDX-License-Identifier: Apache-2.0
// The costs of the analysis by name, for tests that falsify each of them.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "tools/timing/costs.hpp"

namespace timing {

struct CostRow {
  std::string_view name;
  unsigned Costs::* cost;
};

inline constexpr CostRow cost_rows[] = {{"simple", &Costs::simple},
                                        {"multiplication", &Costs::multiplication},
                                        {"bit manipulation", &Costs::bit_manipulation},
                                        {"division", &Costs::division},
                                        {"load", &Costs::load},
                                        {"store", &Costs::store},
                                        {"bus load", &Costs::bus_load},
                                        {"bus store", &Costs::bus_store},
                                        {"not taken", &Costs::not_taken},
                                        {"taken", &Costs::taken},
                                        {"predicted, not taken", &Costs::predicted_not_taken},
                                        {"predicted, taken", &Costs::predicted_taken},
                                        {"jump", &Costs::jump},
                                        {"jump to a register", &Costs::jump_register},
                                        {"fence.i", &Costs::fence_i},
                                        {"CSR instruction", &Costs::csr},
                                        {"return from a trap", &Costs::trap_return},
                                        {"wait for interrupt", &Costs::wait},
                                        {"late result", &Costs::hazard}};

// All but some, which a test's program does not execute.
inline std::vector<CostRow> cost_rows_without(std::initializer_list<unsigned Costs::*> left_out) {
  std::vector<CostRow> rows;
  std::ranges::copy_if(cost_rows, std::back_inserter(rows), [&](const CostRow& row) {
    return std::ranges::find(left_out, row.cost) == left_out.end();
  });
  return rows;
}

}  // namespace timing
