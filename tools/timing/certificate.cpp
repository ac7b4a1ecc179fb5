// SPDX-License-Identifier: Apache-2.0
// The inequalities of duality, each by itself. It shares nothing with what has found the prices.
#include "tools/timing/certificate.hpp"

namespace timing {

namespace {

// Adds a product; false where it does not fit.
bool add_product(Wide& sum, Wide factor, Wide other) {
  Wide product = 0;
  return !__builtin_mul_overflow(factor, other, &product) &&
         !__builtin_add_overflow(sum, product, &sum);
}

}  // namespace

std::optional<Clocks> proved_bound(const LinearProgram& program, const Prices& prices) {
  if (prices.of_rows.size() != program.rows.size() || prices.scale < 1) return std::nullopt;
  for (const Column& column : program.columns) {
    Wide margin = 0;
    if (!add_product(margin, -Wide{column.clocks}, prices.scale)) return std::nullopt;
    for (const auto& [row, factor] : column.entries) {
      if (!add_product(margin, factor, prices.of_rows.at(row))) return std::nullopt;
    }
    if (margin < 0) return std::nullopt;
  }
  Wide bound = 0;
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    if (!program.rows[i].is_equation && prices.of_rows[i] < 0) return std::nullopt;
    if (!add_product(bound, program.rows[i].right_side, prices.of_rows[i])) return std::nullopt;
  }
  bound /= prices.scale;
  if (bound < 0 || bound > Wide{~Clocks{0}}) return std::nullopt;
  return static_cast<Clocks>(bound);
}

}  // namespace timing
