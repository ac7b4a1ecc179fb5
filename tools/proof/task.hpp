// SPDX-License-Identifier: Apache-2.0
// One proof, or one mutation that must break one.
#pragma once

#include <string>
#include <vector>

#include "tools/proof/list.hpp"
#include "tools/proof/workspace.hpp"

namespace proof {

enum class Verdict {
  holds,
  fails,
  undecided,  // the time limit came first
  broken,  // it could not be tried
};

struct Outcome {
  Verdict verdict = Verdict::broken;
  std::vector<std::string> asserted;
  std::vector<std::string> assumed;
  std::vector<std::string> failed;
  std::string explanation;  // where it does not hold: which clock, which part, which trace
  double seconds{};
};

Outcome try_proof(const Folders& folders, const Proof& proof, const std::filesystem::path& sources,
                  std::chrono::seconds limit);

// `holds` where the mutation is caught: within its depth a run from the start breaks
// the named property.
Outcome try_mutation(const Folders& folders, const Mutation& mutation, const Proof& proof,
                     std::chrono::seconds limit);

const char* name_of(Verdict verdict);

}  // namespace proof
