// SPDX-License-Identifier: Apache-2.0
// The call of HiGHS.
#include "tools/timing/solver.hpp"

#include <Highs.h>

namespace timing {

namespace {

HighsLp converted(const LinearProgram& program) {
  HighsLp lp;
  lp.num_col_ = static_cast<HighsInt>(program.columns.size());
  lp.num_row_ = static_cast<HighsInt>(program.rows.size());
  lp.sense_ = ObjSense::kMaximize;
  lp.col_lower_.assign(program.columns.size(), 0);
  lp.col_upper_.assign(program.columns.size(), kHighsInf);
  for (const Constraint& row : program.rows) {
    const auto right_side = static_cast<double>(row.right_side);
    lp.row_lower_.push_back(row.is_equation ? right_side : -kHighsInf);
    lp.row_upper_.push_back(right_side);
  }
  lp.a_matrix_.format_ = MatrixFormat::kColwise;
  lp.a_matrix_.start_ = {0};
  for (const Column& column : program.columns) {
    lp.col_cost_.push_back(static_cast<double>(column.clocks));
    for (const auto& [row, factor] : column.entries) {
      lp.a_matrix_.index_.push_back(static_cast<HighsInt>(row));
      lp.a_matrix_.value_.push_back(static_cast<double>(factor));
    }
    lp.a_matrix_.start_.push_back(static_cast<HighsInt>(lp.a_matrix_.index_.size()));
  }
  return lp;
}

}  // namespace

Solution solve(const LinearProgram& program) {
  Highs highs;
  highs.setOptionValue("output_flag", false);
  highs.setOptionValue("threads", 1);
  if (highs.passModel(converted(program)) == HighsStatus::kError) return {};
  if (highs.run() == HighsStatus::kError) return {};
  const HighsModelStatus status = highs.getModelStatus();
  // Not unbounded: each loop has a bound.
  if (status == HighsModelStatus::kInfeasible ||
      status == HighsModelStatus::kUnboundedOrInfeasible) {
    return {.kind = Solution::Kind::infeasible, .passes = {}, .prices = {}};
  }
  if (status != HighsModelStatus::kOptimal) return {};
  const HighsSolution& solution = highs.getSolution();
  return {.kind = Solution::Kind::optimal,
          .clocks = highs.getInfo().objective_function_value,
          .passes = solution.col_value,
          .prices = solution.row_dual};
}

}  // namespace timing
