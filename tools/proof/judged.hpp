// SPDX-License-Identifier: Apache-2.0
// Questions to a judge, and its verdicts.
#pragma once

#include <string>

namespace proof {

enum class Finding {
  passes,  // sees no difference
  killed,
  refused,  // does not compile, or cannot be synthesized
  equivalent,  // proved to be
};

struct Judged {
  Finding finding{};
  std::string detail;
  bool timed_out = false;  // another run may see more
};

// A unit with another text. The text may differ in what was woven into it.
struct Variant {
  std::string unit;
  std::string simulated;
  std::string synthesized;
};

}  // namespace proof
