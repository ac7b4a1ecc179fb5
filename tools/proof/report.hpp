// SPDX-License-Identifier: Apache-2.0
// The outcome on the terminal and as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/proof/list.hpp"
#include "tools/proof/task.hpp"

namespace proof {

struct Trial {
  Proof proof;
  std::optional<Mutation> mutation;
  Outcome outcome;

  const std::string& name() const { return mutation ? mutation->name : proof.name; }
};

// One line as soon as the trial is done, more where it does not hold.
void print_line(const Trial& trial);
void print_summary(const std::vector<Trial>& trials, double seconds);
// Throws std::runtime_error where the file cannot be written.
void write_json(const std::filesystem::path& file, const std::vector<Trial>& trials,
                double seconds);

}  // namespace proof
