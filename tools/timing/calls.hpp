// SPDX-License-Identifier: Apache-2.0
// The longest time of each function that is called, as a processor executes it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "tools/timing/analysis.hpp"
#include "tools/timing/sample.hpp"

namespace timing {

class Calls {
 public:
  struct Measured {
    Clocks longest{};  // without sleep, from its first instruction to the one behind its end
    std::uint64_t calls{};
  };

  Calls(const Program& program, bool has_zbb) : program_(program), has_zbb_(has_zbb) {}

  // Spans from a place of some to the next of others, which may be the same; under a number.
  void watch(std::uint32_t number, const std::set<Address>& begins, const std::set<Address>& ends);

  // Of each clock, one after the other, from any on.
  void take(const Sample& sample);

  const std::map<Address, Measured>& measured() const { return measured_; }
  Measured span(std::uint32_t number) const { return spans_.at(number).measured; }
  // Returns to a place that no call has left.
  std::uint64_t strays() const { return strays_; }

 private:
  struct Frame {
    Address function{}, back{};
    std::uint64_t begins{}, slept{};
  };

  void pass_spans(const Sample& behind);
  void jump(const Sample& before, const Sample& behind);
  void end(Address back, std::uint64_t begins, std::uint64_t slept);

  const Program& program_;
  bool has_zbb_;
  std::optional<Sample> last_;
  std::vector<Frame> frames_;
  std::map<Address, Measured> measured_;
  std::uint64_t strays_ = 0;
  struct Span {
    std::set<Address> begins, ends;
    std::optional<std::uint64_t> began;
    std::uint64_t slept{};
    Measured measured;
  };
  std::map<std::uint32_t, Span> spans_;
  std::set<Address> places_;  // where one begins or ends
};

}  // namespace timing
