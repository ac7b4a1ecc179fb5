// SPDX-License-Identifier: Apache-2.0
// Calls of the programs that libFuzzer drives.
#include "tools/command/fuzz_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"

namespace command {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "fuzz_";

fs::path fuzz_folder() { return build_folder() / "fuzz"; }
fs::path kept_corpus(const std::string& target) {
  return project_folder() / "tests" / "fuzz" / "corpus" / target;
}
std::string program_of(const std::string& target) {
  return (fuzz_folder() / "bin" / (std::string(prefix) + target)).string();
}

std::vector<std::string> all_targets() {
  std::vector<std::string> targets;
  for (const auto& entry : fs::directory_iterator(fuzz_folder() / "bin")) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix)) targets.push_back(name.substr(prefix.size()));
  }
  std::ranges::sort(targets);
  return targets;
}

bool run(const std::string& target, const FuzzOptions& options, const fs::path& found) {
  const fs::path findings = fuzz_folder() / "findings";
  fs::create_directories(findings);
  fs::create_directories(found);
  const bool good = run_program({program_of(target), fmt::format("-runs={}", options.executions),
                                 fmt::format("-seed={}", options.seed), "-print_final_stats=1",
                                 fmt::format("-artifact_prefix={}/{}-", findings.string(), target),
                                 found.string(), kept_corpus(target).string()}) == 0;
  if (!good) {
    fmt::print(stderr,
               "stepfabric: {} violates a property; the input is in {}, and the program {} "
               "takes its name\n",
               target, findings.string(), program_of(target));
  }
  return good;
}

// Replaces the corpus by the fewest inputs with the same coverage.
bool minimise(const std::string& target, const fs::path& found) {
  const fs::path kept = kept_corpus(target);
  const fs::path fewest = fuzz_folder() / "minimised" / target;
  fs::remove_all(fewest);
  fs::create_directories(fewest);
  if (run_program({program_of(target), "-set_cover_merge=1", "-use_counters=0", fewest.string(),
                   kept.string(), found.string()}) != 0) {
    return false;
  }
  fs::remove_all(kept);
  fs::copy(fewest, kept);
  return true;
}

}  // namespace

int fuzz(const FuzzOptions& options) {
  fmt::print(stderr, "stepfabric: building the fuzz targets, log in {}\n",
             (build_folder() / "build.log").string());
  build({"fuzz_programs"});
  const std::vector<std::string> known = all_targets();
  for (const std::string& target : options.targets) {
    if (!std::ranges::contains(known, target)) {
      throw std::runtime_error(
          fmt::format("there is no fuzz target {}; there are {}", target, fmt::join(known, ", ")));
    }
  }
  bool good = true;
  for (const std::string& target : options.targets.empty() ? known : options.targets) {
    const fs::path found = fuzz_folder() / "corpus" / target;
    fmt::print(stderr, "stepfabric: fuzzing {}\n", target);
    if (!run(target, options, found)) {
      good = false;
    } else if (options.minimise) {
      good = minimise(target, found) && good;
    }
  }
  return good ? success : failure;
}

}  // namespace command
