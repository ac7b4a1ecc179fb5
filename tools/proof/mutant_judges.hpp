// SPDX-License-Identifier: Apache-2.0
// What distinguishes a mutant from the original: benches, proofs run from the start, and the
// comparison of both netlists.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tools/proof/list.hpp"
#include "tools/proof/source_tree.hpp"
#include "tools/proof/workspace.hpp"

namespace proof {

enum class Finding {
  passes,  // sees no difference
  killed,
  refused,  // does not compile, or cannot be synthesized
  equivalent,  // proved to be
};

struct Judged {
  Finding finding{};
  std::string detail;
};

// A unit with another text. The text may differ in what was woven into it.
struct Variant {
  std::string unit;
  std::string simulated;
  std::string synthesized;
};

class Judges {
 public:
  // Weaves the sources into `work`.
  Judges(const Folders& folders, const List& list);

  const SourceTree& simulated() const { return simulated_; }
  const SourceTree& synthesized() const { return synthesized_; }

  // Benches of the unit itself (UNIT_tb and UNIT_..._tb), and the others of its folder that contain
  // it: not those of the whole chip, which take minutes.
  std::vector<std::string> own_benches(const std::string& unit) const;
  std::vector<std::string> other_benches(const std::string& unit) const;
  // Proofs with clocks of an entity that is or contains the unit; those of the unit itself first.
  std::vector<Proof> proofs_of(const std::string& unit) const;
  // What is compared: the unit itself, or for a package all entities of its folder that use it.
  std::vector<std::string> compared_entities(const std::string& unit) const;

  // `folder` is for this call alone. A bench or proof that does not pass as it is is an error.
  Judged ask_bench(const std::string& bench, const Variant& variant,
                   const std::filesystem::path& folder);
  Judged ask_proof(const Proof& proof, const Variant& variant, const std::filesystem::path& folder);
  Judged compare(const Variant& variant, const std::filesystem::path& folder);

  // Processor time of a bench as it is.
  double bench_seconds(const std::string& bench, const std::filesystem::path& folder);
  // What was measured in an earlier campaign.
  void know_seconds(const std::string& bench, double seconds);

  // Everything that the answer of a judge depends on, with the variant in its place.
  std::string key_of_bench(const std::string& bench, const Variant& variant) const;
  std::string key_of_proof(const Proof& proof, const Variant& variant) const;
  std::string key_of_comparison(const Variant& variant) const;

 private:
  struct Original {
    std::once_flag once;
    std::string netlist;  // file
    std::string verilog;
  };
  std::string key(const SourceTree& tree, const std::string& top, const std::string& text,
                  const Variant& variant) const;
  std::vector<std::string> files(const SourceTree& tree, const std::string& top,
                                 const std::string& unit, const std::string& stand_in) const;
  std::optional<std::string> synthesize(const std::string& top, const std::string& unit,
                                        const std::string& stand_in,
                                        const std::map<std::string, std::string>& generics,
                                        const std::filesystem::path& folder) const;
  // Those of a proof of the entity that has some, because a small memory is compared in seconds.
  std::map<std::string, std::string> compared_generics(const std::string& entity) const;
  // Which properties are proved of an entity with these generics, for all times.
  std::optional<Choice> invariants_of(const std::string& entity) const;
  std::string write_netlist(const std::string& verilog, const std::string& entity, const char* name,
                            const std::filesystem::path& folder) const;
  const Original& original(const std::string& entity);
  Judged compare_in(const std::string& entity, const Variant& variant,
                    const std::filesystem::path& folder);

  Folders folders_;
  List list_;
  SourceTree simulated_;
  SourceTree synthesized_;
  std::mutex mutex_;
  std::map<std::string, double> seconds_;
  std::map<std::string, std::unique_ptr<Original>> originals_;
};

}  // namespace proof
