// SPDX-License-Identifier: Apache-2.0
// The bounds of functions as a text and as JSON.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/timing/analysis.hpp"

namespace timing {

struct Row {
  std::string name;
  Address address{};
  std::optional<Clocks> clocks;
  std::optional<std::uint32_t> stack_bytes;
  std::set<Problem> problems;  // of it and of what it calls
  std::set<Problem> stack_problems;
};

// Of these functions, or of all. Throws std::runtime_error for a name that the image does not have.
std::vector<Row> bounds(const Program& program, const Costs& costs, bool has_zbb,
                        const std::vector<std::string>& names);

std::string to_text(const std::vector<Row>& rows);
std::string to_json(const std::vector<Row>& rows);

}  // namespace timing
