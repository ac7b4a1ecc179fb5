// SPDX-License-Identifier: Apache-2.0
// Reading of the table of times.
#include "sim/processor/timing_table.hpp"

#include <fstream>
#include <regex>
#include <stdexcept>

namespace processor {

TimingTable::TimingTable() {
  std::ifstream file(TIMING_TABLE_FILE);
  const std::regex row(R"(\| ([^|]+) \| (\d+) \|.*)");
  std::string line;
  std::smatch match;
  while (std::getline(file, line)) {
    if (std::regex_match(line, match, row)) {
      clocks_[match[1]] = static_cast<unsigned>(std::stoul(match[2]));
    }
  }
  if (clocks_.empty()) throw std::runtime_error("the table of times has no row");
}

unsigned TimingTable::at(const std::string& row) const {
  const auto found = clocks_.find(row);
  if (found == clocks_.end()) throw std::runtime_error("the table of times has no row " + row);
  return found->second;
}

}  // namespace processor
