// SPDX-License-Identifier: Apache-2.0
// Rows of functions, and the problems of those without a bound.
#include "tools/timing/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/timing/stack.hpp"

namespace timing {

std::vector<Row> bounds(const Program& program, const Costs& costs, bool has_zbb,
                        const std::vector<std::string>& names) {
  refuse_interrupts(program, has_zbb);
  std::vector<Address> functions;
  for (const std::string& name : names) {
    const auto found = program.find(name);
    if (found.empty()) {
      throw std::runtime_error(name + ": the image has no such function (it may be inlined)");
    }
    functions.insert(functions.end(), found.begin(), found.end());
  }
  if (names.empty()) {
    for (const auto& [address, symbol] : program.symbols) {
      if (symbol.size != 0) functions.push_back(address);
    }
  }
  std::vector<Row> rows;
  for (const Address function : functions) {
    // A new one each time, so that each row has its own problems.
    Analysis analysis(program, costs, has_zbb);
    const auto clocks = analysis.bound(function);
    Stack stack(program, has_zbb);
    const auto stack_bytes = stack.depth(function);
    rows.push_back({.name = program.symbols.at(function).name,
                    .address = function,
                    .clocks = clocks,
                    .stack_bytes = stack_bytes,
                    .problems = analysis.problems(),
                    .stack_problems = stack.problems()});
  }
  return rows;
}

namespace {

std::string stack_text(const Row& row) {
  return row.stack_bytes ? fmt::format("{:>6} bytes of stack ", *row.stack_bytes)
                         : fmt::format("{:>6} bytes of stack ", "?");
}

nlohmann::json to_json(const std::set<Problem>& problems) {
  auto list = nlohmann::json::array();
  for (const Problem& problem : problems) {
    list.push_back({{"place", problem.place},
                    {"function", problem.function},
                    {"what", problem.what},
                    {"remedy", problem.remedy}});
  }
  return list;
}

}  // namespace

std::string to_text(const std::vector<Row>& rows) {
  std::string text;
  std::set<Problem> problems;
  std::size_t bounded = 0;
  for (const Row& row : rows) {
    if (row.clocks) {
      ++bounded;
      text += fmt::format("{:>12} clocks {} {}\n", *row.clocks, stack_text(row), row.name);
    }
    problems.insert(row.problems.begin(), row.problems.end());
    problems.insert(row.stack_problems.begin(), row.stack_problems.end());
  }
  for (const Row& row : rows) {
    if (!row.clocks) {
      text += fmt::format("{:>12}        {} {}\n", "no bound", stack_text(row), row.name);
    }
  }
  for (const Problem& problem : problems) text += to_text(problem) + "\n";
  return text + fmt::format("{} of {} functions have a bound\n", bounded, rows.size());
}

std::string to_json(const std::vector<Row>& rows) {
  auto functions = nlohmann::json::array();
  for (const Row& row : rows) {
    nlohmann::json function{{"name", row.name},
                            {"address", row.address},
                            {"problems", to_json(row.problems)},
                            {"stack_problems", to_json(row.stack_problems)}};
    if (row.clocks) function["clocks"] = *row.clocks;
    if (row.stack_bytes) function["stack_bytes"] = *row.stack_bytes;
    functions.push_back(function);
  }
  return nlohmann::json{{"functions", functions}}.dump(2) + "\n";
}

}  // namespace timing
