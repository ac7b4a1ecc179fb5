// SPDX-License-Identifier: Apache-2.0
// The judges of mutants: benches, proofs run from the start, and the comparison of both netlists.
#pragma once

#include "tools/proof/bench_judge.hpp"
#include "tools/proof/netlist_judge.hpp"
#include "tools/proof/proof_judge.hpp"

namespace proof {

struct Judges {
  Judges(const Folders& folders, const List& list)
      : sources(folders), benches(sources), netlists(sources, list), proofs(sources, list) {}

  JudgedSources sources;
  BenchJudge benches;
  NetlistJudge netlists;
  ProofJudge proofs;
};

}  // namespace proof
