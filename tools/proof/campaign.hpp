// SPDX-License-Identifier: Apache-2.0
// `prove --mutants`: tries systematic faults on all judges that could detect them, cheapest first.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/proof/mutant_list.hpp"
#include "tools/proof/mutants.hpp"

namespace proof {

enum class Fate {
  killed,
  refused,  // by compiler or synthesis: not a possible fault of the chip, not counted
  proved_equivalent,
  judged_equivalent,  // by a person, with the reason
  surviving,
};

const char* name_of(Fate fate);

struct MutantOutcome {
  std::string unit;
  Mutant mutant;
  Fate fate{};
  std::string by;  // what killed it, or how it was decided
  bool is_listed = false;  // as surviving
  bool is_quick = false;  // tried on its own and on short benches, and by comparison
  double seconds{};
};

struct Count {
  int killed = 0;
  int refused = 0;
  int proved_equivalent = 0;
  int judged_equivalent = 0;
  int surviving = 0;

  int counted() const { return killed + surviving; }
  // Killed of those that are not equivalent, from 0 to 1; 1 where there are none.
  double score() const { return counted() == 0 ? 1 : static_cast<double>(killed) / counted(); }
};

Count count(const std::vector<MutantOutcome>& outcomes, const std::string& unit = "");

struct CampaignOptions {
  std::vector<std::string> units;  // files or entities; empty: all of rtl/motion and rtl/thermal
  int sample = 0;  // so many, chosen by the seed; 0: all
  std::optional<std::uint64_t> seed;  // without one it is made of the files' contents
  std::filesystem::path json;
  bool quick = false;  // only its own benches, short ones that contain it, and the comparison
  bool recorded = false;  // not those that testbench/proofs/mutants says were not tried
  bool untried = false;  // only those; their list keeps what it says of the others
  bool surviving = false;  // only those that the lists say survived; keeps the others as well
  bool record = false;  // write the outcomes into testbench/proofs/mutants
  unsigned jobs = 0;
};

// The numbers 0 .. all - 1, or `wanted` of them in rising order, the same for the same seed.
std::vector<std::size_t> sample_of(std::size_t all, std::size_t wanted, std::uint64_t seed);

// The entries that are not right any more: of mutants that are not made, and, among `outcomes`, of
// such that are killed or refused. A proof of equivalence refutes none. One line for each.
std::vector<std::string> stale_entries(const std::map<std::string, Judgement>& judgements,
                                       const std::vector<std::string>& made,
                                       const std::vector<MutantOutcome>& outcomes);

// Whether the result is good enough: nothing stale; of a sample every survivor is listed; otherwise
// at least 97 % of those that are not equivalent are killed, over all and in no file a survivor
// that is not listed.
bool is_good(const std::vector<MutantOutcome>& outcomes, const std::vector<std::string>& stale,
             bool is_sample);

// Throws std::runtime_error for a name that is no file there, and for an invalid list.
bool run_campaign(const CampaignOptions& options, const std::filesystem::path& project,
                  const std::filesystem::path& build);

}  // namespace proof
