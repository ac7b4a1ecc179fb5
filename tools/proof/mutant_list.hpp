// SPDX-License-Identifier: Apache-2.0
// Judgements of mutants by a person: testbench/proofs/mutants/FILE.toml.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace proof {

struct Judgement {
  enum class Kind {
    equivalent,  // no behaviour that anyone relies on differs; the reason says why
    surviving,  // it should be found and is not yet
  };
  Kind kind{};
  std::string reason;
};

// By the ids of mutants. Throws std::runtime_error for an entry without a reason, one that stands
// there twice and one that this program does not know.
std::map<std::string, Judgement> read_judgements(const std::filesystem::path& folder);

}  // namespace proof
