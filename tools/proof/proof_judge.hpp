// SPDX-License-Identifier: Apache-2.0
// Judges mutants by proofs, run from the start.
#pragma once

#include "tools/proof/judged_sources.hpp"
#include "tools/proof/list.hpp"

namespace proof {

class ProofJudge {
 public:
  ProofJudge(const JudgedSources& sources, const List& list) : sources_(sources), list_(list) {}

  // Proofs with clocks of an entity that is or contains the unit; those of the unit itself first.
  std::vector<Proof> proofs_of(const std::string& unit) const;

  // `folder` is for this call alone.
  Judged ask(const Proof& proof, const Variant& variant, const std::filesystem::path& folder) const;

  // Everything that the answer depends on, with the variant in its place.
  std::string key(const Proof& proof, const Variant& variant) const;

 private:
  const JudgedSources& sources_;
  List list_;
};

}  // namespace proof
