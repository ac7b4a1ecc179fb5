// SPDX-License-Identifier: Apache-2.0
// The table of times in rtl/processor/timing.md.
#pragma once

#include <map>
#include <string>

namespace processor {

class TimingTable {
 public:
  // Reads the rows `| name | clocks |`. Throws std::runtime_error where there are none.
  TimingTable();

  // The clocks of a row; throws std::runtime_error naming a row that is not there.
  unsigned at(const std::string& row) const;

 private:
  std::map<std::string, unsigned> clocks_;
};

}  // namespace processor
