// SPDX-License-Identifier: Apache-2.0
// The checks of the analysis, on one function.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/processor/timing_table.hpp"
#include "tests/timing/second_solver.hpp"
#include "tests/timing/seeded_faults.hpp"
#include "tools/timing/flow.hpp"
#include "tools/timing/pricing.hpp"
#include "tools/timing/solver.hpp"

namespace timing {

namespace {

const Address function = MeasuredProgram::address(place::function);

std::string shorter_than(std::optional<Clocks> bound, Clocks measured) {
  if (bound && *bound >= measured) return "";
  return bound ? fmt::format("a bound of {} clocks, {} were measured", *bound, measured) : "";
}

}  // namespace

Proof proof_of(Networks networks) {
  Proof proof{.networks = std::move(networks), .rows = {}, .prices = {}};
  proof.rows = program_of(proof.networks);
  std::vector<Wide> of_facts;
  const auto prices = solve(proof.rows).prices;
  for (std::size_t i = 0; i < proof.networks.facts.size(); ++i) {
    of_facts.emplace_back(std::llround(prices.at(RowNumbers(proof.networks).fact(i))));
  }
  proof.prices = price(proof.networks, 1, of_facts);
  return proof;
}

Tool::Tool()
    : measured(measured_program()),
      program(measured.program),
      costs(processor::TimingTable()),
      steps(measured.steps),
      span_end(MeasuredProgram::address(place::run_begins)),
      proof(proof_of(Analysis(program, costs, true).networks(function).value())) {}

void Tool::replace(std::size_t number, processor::encode::Word word) {
  for (std::size_t i = 0; i < 4; ++i) {
    program.bytes.at(4 * number + i) = static_cast<std::uint8_t>(word >> (8 * i));
  }
}

std::string cost_sum(const Tool& tool) {
  const std::uint64_t sum = sum_of_costs(tool.program, tool.costs, tool.steps);
  if (sum == tool.measured.clocks) return "";
  return fmt::format("costs of {} clocks, {} were measured", sum, tool.measured.clocks);
}

std::string measured_time(const Tool& tool) {
  return shorter_than(bound_of(tool.program, tool.costs), tool.measured.clocks);
}

std::string measured_span(const Tool& tool) {
  Analysis analysis(tool.program, tool.costs, true);
  return shorter_than(analysis.span(function, {function}, {tool.span_end}), tool.measured.span);
}

std::string refusal(const Tool& tool) {
  if (place_that_enables_interrupts(tool.program, true)) return "interrupts run code";
  Analysis analysis(tool.program, tool.costs, true);
  if (analysis.bound(function)) return "";
  return analysis.problems().empty() ? "no bound" : analysis.problems().begin()->what;
}

std::string certificate(const Tool& tool) {
  return proved_bound(tool.proof.rows, tool.proof.prices) ? "" : "the prices prove nothing";
}

std::string proved_time(const Tool& tool) {
  return shorter_than(proved_bound(tool.proof.rows, tool.proof.prices), tool.measured.clocks);
}

std::string second_opinion(const Tool& tool) {
  const auto proved = proved_bound(tool.proof.rows, tool.proof.prices);
  const auto optimum = optimum_in_integers(tool.proof.rows);
  if (proved && optimum && static_cast<double>(*proved) == *optimum) return "";
  return fmt::format("{} clocks are proved, the optimum is {}", proved.value_or(0),
                     optimum.value_or(-1));
}

}  // namespace timing
