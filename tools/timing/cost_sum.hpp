// SPDX-License-Identifier: Apache-2.0
// The costs that the analysis gives to instructions, added up along a run and compared with the
// clocks that pass.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/timing/costs.hpp"
#include "tools/timing/sample.hpp"

namespace timing {

class CostSum {
 public:
  // An instruction that did not take its costs.
  struct Difference {
    Address address{};
    std::uint64_t costs{}, clocks{};
  };

  CostSum(const Program& program, const Costs& costs, bool has_zbb)
      : program_(program), costs_(costs), has_zbb_(has_zbb) {}

  // Of each clock, one after the other.
  void take(const Sample& sample);

  // Of the program's code, without the first one and the one behind the boot loader.
  std::uint64_t instructions() const { return instructions_; }
  std::uint64_t costs() const { return sum_; }
  // Without sleep, as mcycle counts them.
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t slept() const { return slept_; }
  // Instructions that are not of the program's code.
  std::uint64_t outside() const { return outside_; }

  std::uint64_t differences() const { return differences_; }
  const std::optional<Difference>& first_difference() const { return first_; }

  std::string text() const;

 private:
  void execute(const Sample& behind);  // the next instruction of the last sample

  const Program& program_;
  Costs costs_;
  bool has_zbb_;
  std::optional<Sample> last_;
  std::optional<Address> before_;  // the instruction before
  std::uint64_t slept_before_ = 0;
  bool accesses_ = false;
  std::uint64_t instructions_ = 0, sum_ = 0, clocks_ = 0, slept_ = 0, outside_ = 0,
                differences_ = 0;
  std::optional<Difference> first_;
};

}  // namespace timing
