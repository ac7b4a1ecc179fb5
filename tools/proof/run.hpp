// SPDX-License-Identifier: Apache-2.0
// The job `prove`: tries what is requested, on several processor cores.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/proof/campaign.hpp"

namespace proof {

struct Options {
  std::vector<std::string> names;  // proofs or mutations; empty: all
  bool quick = false;  // only the proofs that take seconds
  bool all = false;  // also what is recorded
  bool mutations = true;
  bool proofs = true;
  unsigned jobs = 0;  // 0: one for each processor core
  unsigned limit_seconds = 600;  // for each call of the solver
  std::filesystem::path json;
  bool record = false;  // write what holds into the list of records, or of the mutants
  int sample = 0;  // so many of what is recorded, or of the mutants
  std::optional<std::uint64_t> seed;  // of the sample
  bool mutants = false;  // instead of all this: systematic mutants of the files in `names`
  CampaignOptions campaign;
};

void add_options(CLI::App& job, Options& options);

// Returns true where everything that was tried holds. Throws std::runtime_error for a name that is
// not in the list, or an invalid list.
bool prove(const Options& options, const std::filesystem::path& project,
           const std::filesystem::path& build);

}  // namespace proof
