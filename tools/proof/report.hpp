// SPDX-License-Identifier: Apache-2.0
// Reports the outcome on the terminal and as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/proof/list.hpp"
#include "tools/proof/records.hpp"
#include "tools/proof/task.hpp"

namespace proof {

struct Trial {
  Proof proof;
  std::optional<Mutation> mutation{};
  std::optional<std::string> digest{};  // of what it depends on
  bool is_recorded = false;  // as holding or caught, with this digest
  bool is_tried = true;
  Outcome outcome{};

  const std::string& name() const { return mutation ? mutation->name : proof.name; }
  Recorded recorded_outcome() const { return mutation ? Recorded::caught : Recorded::holds; }
};

// How many are tried, with the seed of the sample.
void print_choice(const std::vector<Trial>& trials, std::optional<std::uint64_t> seed);
// One line as soon as the trial is done, more where it does not hold.
void print_line(const Trial& trial);
void print_summary(const std::vector<Trial>& trials, double seconds);
// Throws std::runtime_error where the file cannot be written.
void write_json(const std::filesystem::path& file, const std::vector<Trial>& trials,
                double seconds);

}  // namespace proof
