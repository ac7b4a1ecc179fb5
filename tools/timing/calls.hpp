// SPDX-License-Identifier: Apache-2.0
// The longest time of each function that is called, as a processor executes it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "tools/timing/analysis.hpp"

namespace timing {

// What the processor shows after a clock.
struct Sample {
  std::uint64_t clock{};
  std::uint64_t instructions{};  // that it has executed
  std::uint64_t slept{};
  Address program_counter{};
};

class Calls {
 public:
  struct Measured {
    Clocks longest{};  // without sleep, from its first instruction to the one behind its end
    std::uint64_t calls{};
  };

  Calls(const Program& program, const Costs& costs, bool has_zbb)
      : program_(program), costs_(costs), has_zbb_(has_zbb) {}

  // Rounds of a loop, by the address at which it begins.
  void watch_rounds(Address start) { round_start_ = start; }

  // Of each clock, one after the other.
  void take(const Sample& sample);

  const std::map<Address, Measured>& measured() const { return measured_; }
  const Measured& rounds() const { return rounds_; }
  // Returns to a place that no call has left.
  std::uint64_t strays() const { return strays_; }

 private:
  struct Frame {
    Address function{}, back{};
    std::uint64_t begins{}, slept{};
  };

  void begin_round(const Sample& before, const Sample& behind);
  void jump(const Sample& before, const Sample& behind);
  void end(Address back, std::uint64_t begins, std::uint64_t slept);

  const Program& program_;
  Costs costs_;
  bool has_zbb_;
  Sample last_;
  std::vector<Frame> frames_;
  std::map<Address, Measured> measured_;
  std::uint64_t strays_ = 0;
  std::optional<Address> round_start_;
  Measured rounds_;
  std::uint64_t round_began_ = 0, round_slept_ = 0;
};

}  // namespace timing
