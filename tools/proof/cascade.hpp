// SPDX-License-Identifier: Apache-2.0
// Tries one mutant after the other on its judges, the cheapest first.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "tools/proof/campaign.hpp"
#include "tools/proof/findings.hpp"
#include "tools/proof/mutant_judges.hpp"

namespace proof {

// A file of the chip as it is.
struct Unit {
  std::string name;
  std::string text;
};

class Cascade {
 public:
  Cascade(Judges& judges, Findings& findings) : judges_(judges), findings_(findings) {}

  // `quick`: on its own and on short benches, and by comparison alone.
  MutantOutcome try_mutant(const Unit& unit, const Mutant& mutant,
                           const std::filesystem::path& folder, bool quick);

 private:
  template <typename Ask>
  Judged ask(const std::string& key, const Ask& judge) {
    if (const auto found = findings_.find(key)) return *found;
    const Judged judged = judge();
    findings_.add(key, judged);
    return judged;
  }

  // Measured once for each text of the bench and what it needs.
  double bench_seconds(const std::string& bench, const std::filesystem::path& folder);
  void decide(const Unit& unit, std::size_t choice, const std::filesystem::path& folder, bool quick,
              MutantOutcome& outcome);

  std::string last_killer(const std::string& unit);

  Judges& judges_;
  Findings& findings_;
  std::mutex timing_;
  std::mutex mutex_;
  std::map<std::string, std::string> killers_;  // by unit: the short bench that killed last
};

}  // namespace proof
