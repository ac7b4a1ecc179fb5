// SPDX-License-Identifier: Apache-2.0
// The call of GLPK.
#include "tests/timing/second_solver.hpp"

#include <glpk.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace timing {

std::optional<double> optimum_in_integers(const LinearProgram& program) {
  if (program.columns.empty()) return std::nullopt;
  glp_term_out(GLP_OFF);
  const std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> problem(glp_create_prob(),
                                                                      &glp_delete_prob);
  glp_set_obj_dir(problem.get(), GLP_MAX);
  glp_add_rows(problem.get(), static_cast<int>(program.rows.size()));
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    const auto right_side = static_cast<double>(program.rows[i].right_side);
    glp_set_row_bnds(problem.get(), static_cast<int>(i) + 1,
                     program.rows[i].is_equation ? GLP_FX : GLP_UP, right_side, right_side);
  }
  glp_add_cols(problem.get(), static_cast<int>(program.columns.size()));
  for (std::size_t i = 0; i < program.columns.size(); ++i) {
    const Column& column = program.columns[i];
    // GLPK counts from 1.
    std::vector<int> rows{0};
    std::vector<double> factors{0};
    for (const auto& [row, factor] : column.entries) {
      rows.push_back(static_cast<int>(row) + 1);
      factors.push_back(static_cast<double>(factor));
    }
    const int place = static_cast<int>(i) + 1;
    glp_set_col_bnds(problem.get(), place, GLP_LO, 0, 0);
    glp_set_col_kind(problem.get(), place, GLP_IV);
    glp_set_obj_coef(problem.get(), place, static_cast<double>(column.clocks));
    glp_set_mat_col(problem.get(), place, static_cast<int>(column.entries.size()), rows.data(),
                    factors.data());
  }
  // Its presolver for whole numbers finds no solution of some programs that have one.
  glp_smcp fractions;
  glp_init_smcp(&fractions);
  fractions.msg_lev = GLP_MSG_OFF;
  if (glp_simplex(problem.get(), &fractions) != 0) throw std::runtime_error("GLPK has failed");
  if (glp_get_status(problem.get()) == GLP_NOFEAS) return std::nullopt;
  glp_iocp settings;
  glp_init_iocp(&settings);
  settings.msg_lev = GLP_MSG_OFF;
  const int result = glp_intopt(problem.get(), &settings);
  if (glp_mip_status(problem.get()) == GLP_NOFEAS) return std::nullopt;
  if (result != 0 || glp_mip_status(problem.get()) != GLP_OPT) {
    throw std::runtime_error("GLPK has found no optimum");
  }
  return glp_mip_obj_val(problem.get());
}

}  // namespace timing
