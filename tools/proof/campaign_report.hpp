// SPDX-License-Identifier: Apache-2.0
// A campaign on the terminal, as JSON and as the lists in testbench/proofs/mutants.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tools/proof/campaign.hpp"

namespace proof {

// A line for each survivor, and one for every hundredth mutant.
void print_progress(const MutantOutcome& outcome, std::size_t done, std::size_t all);
// A table of the files, and the errors of the lists.
void print_campaign(const std::vector<MutantOutcome>& outcomes,
                    const std::vector<std::string>& stale, double seconds);
// Throws std::runtime_error where a file cannot be written.
void write_campaign(const std::filesystem::path& file, const std::vector<MutantOutcome>& outcomes,
                    const std::vector<std::string>& stale, bool good, double seconds);
// The fate of those that were not tried.
inline constexpr const char* not_tried = "not tried";
// UNIT.tsv for each file of which some were tried, or that has none yet: fate, by what, id of all
// that are made of it; of those that were not tried, that they were not, or with `keeps_others`
// what their list says already. And RESULTS.md.
void record_campaign(const std::filesystem::path& folder,
                     const std::vector<MutantOutcome>& outcomes,
                     const std::vector<std::string>& made, bool keeps_others = false);
// The ids that the lists give this fate, or `not_tried`.
std::set<std::string> mutants_listed_as(const std::string& fate,
                                        const std::filesystem::path& folder);

}  // namespace proof
