// SPDX-License-Identifier: Apache-2.0
// Runs both chips in step, and compares their outputs.
#include "tests/chip/twins.hpp"

#include <fmt/format.h>

namespace tests {

void Twins::compare() {
  now_ = first_.now();
  outputs_ = expected_outputs();
  if (second_.now() != now_ || second_.outputs() != outputs_) {
    throw TwinsDiffer(
        fmt::format("the first chip's pins are {:#x} at clock {}, the second's {:#x} at {}",
                    outputs_.word, now_, second_.outputs().word, second_.now()));
  }
}

void Twins::advance(sim::Clock limit) {
  first_.inputs() = inputs_;
  second_.inputs() = inputs_;
  first_.advance(limit);
  // Returns earlier where its pins change earlier.
  second_.advance(first_.now());
  compare();
}

void Twins::reset() {
  first_.reset();
  second_.reset();
  compare();
}

}  // namespace tests
