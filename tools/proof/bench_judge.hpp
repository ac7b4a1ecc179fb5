// SPDX-License-Identifier: Apache-2.0
// Judges mutants by test benches.
#pragma once

#include <map>
#include <mutex>

#include "tools/proof/judged_sources.hpp"

namespace proof {

class BenchJudge {
 public:
  explicit BenchJudge(const JudgedSources& sources) : sources_(sources) {}

  // Benches of the unit itself (UNIT_tb and UNIT_..._tb), and the others of its folder that contain
  // it: not those of the whole chip, which take minutes.
  std::vector<std::string> own_benches(const std::string& unit) const;
  std::vector<std::string> other_benches(const std::string& unit) const;

  // `folder` is for this call alone. A bench that does not pass without a mutant is an error.
  Judged ask(const std::string& bench, const Variant& variant, const std::filesystem::path& folder);

  // Processor time of a bench without a mutant.
  double seconds(const std::string& bench, const std::filesystem::path& folder);
  // What was measured in an earlier campaign.
  void know_seconds(const std::string& bench, double seconds);

  // Everything that the answer depends on, with the variant in its place.
  std::string key(const std::string& bench, const Variant& variant) const;

 private:
  const JudgedSources& sources_;
  std::mutex mutex_;
  std::map<std::string, double> seconds_;
};

}  // namespace proof
