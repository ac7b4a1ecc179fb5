// SPDX-License-Identifier: Apache-2.0
// Judges are called only where there is no cached verdict.
#include "tools/proof/cascade.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>

namespace proof {

namespace fs = std::filesystem;

namespace {

std::string changed(const Unit& unit, const std::string& woven, const Mutant& mutant,
                    std::size_t choice) {
  if (!woven.starts_with(std::string_view(unit.text).substr(0, mutant.end))) {
    throw std::runtime_error(unit.name + ": the weaver changes more than the end");
  }
  return with_mutant(woven, mutant, choice);
}

// Returns true where this decides.
bool takes(const Judged& judged, MutantOutcome& outcome) {
  outcome.by = judged.detail;
  switch (judged.finding) {
    case Finding::passes:
      outcome.fate = Fate::surviving;
      return false;
    case Finding::killed:
      outcome.fate = Fate::killed;
      return true;
    case Finding::refused:
      outcome.fate = Fate::refused;
      return true;
    case Finding::equivalent:
      outcome.fate = Fate::proved_equivalent;
      return true;
  }
  return true;
}

}  // namespace

MutantOutcome Cascade::try_mutant(const Unit& unit, const Mutant& mutant, const fs::path& folder,
                                  bool quick) {
  const auto start = std::chrono::steady_clock::now();
  MutantOutcome outcome{unit.name, mutant, Fate::refused, "", false, quick, 0};
  // The first text that compiles counts.
  for (std::size_t choice = 0; choice < mutant.texts.size(); ++choice) {
    decide(unit, choice, folder, quick, outcome);
    if (outcome.fate != Fate::refused) break;
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

double Cascade::bench_seconds(const std::string& bench, const fs::path& folder) {
  const std::string key = "time_" + judges_.benches.key(bench, {});
  // What one worker measures the others need as well.
  const std::scoped_lock lock(timing_);
  const Judged seconds = ask(key, [&] {
    return Judged{Finding::passes, std::to_string(judges_.benches.seconds(bench, folder))};
  });
  judges_.benches.know_seconds(bench, std::stod(seconds.detail));
  return std::stod(seconds.detail);
}

std::string Cascade::last_killer(const std::string& unit) {
  const std::scoped_lock lock(mutex_);
  return killers_[unit];
}

void Cascade::decide(const Unit& unit, std::size_t choice, const fs::path& folder, bool quick,
                     MutantOutcome& outcome) {
  const Variant variant{
      unit.name,
      changed(unit, judges_.sources.simulated().text_of(unit.name), outcome.mutant, choice),
      changed(unit, judges_.sources.synthesized().text_of(unit.name), outcome.mutant, choice)};
  const auto ask_bench = [&](const std::string& bench) {
    bench_seconds(bench, folder);
    return takes(ask(judges_.benches.key(bench, variant),
                     [&] { return judges_.benches.ask(bench, variant, folder); }),
                 outcome);
  };
  const auto ask_proof = [&](const Proof& proof) {
    return takes(ask(judges_.proofs.key(proof, variant),
                     [&] { return judges_.proofs.ask(proof, variant, folder); }),
                 outcome);
  };
  const auto is_killed_soon = [&](const std::string& bench) {
    if (!ask_bench(bench)) return false;
    const std::scoped_lock lock(mutex_);
    if (outcome.fate == Fate::killed) killers_[unit.name] = bench;
    return true;
  };
  // What killed the mutant before, which lies near in the text, mostly kills at once.
  const std::string killer = last_killer(unit.name);
  if (!killer.empty() && is_killed_soon(killer)) return;
  if (std::ranges::any_of(judges_.benches.own_benches(unit.name), is_killed_soon)) return;
  // The judges in order: short benches, which take less than a solver; comparison; proofs of the
  // unit; long benches; proofs of entities that contain it.
  std::vector<std::string> benches = judges_.benches.other_benches(unit.name);
  std::map<std::string, double> seconds;
  for (const std::string& bench : benches) seconds[bench] = bench_seconds(bench, folder);
  std::ranges::sort(benches, {}, [&seconds](const std::string& bench) { return seconds[bench]; });
  constexpr double short_seconds = 5;
  const auto is_decided_by_benches = [&](bool are_short) {
    return std::ranges::any_of(benches, [&](const std::string& bench) {
      return (seconds[bench] < short_seconds) == are_short &&
             (are_short ? is_killed_soon(bench) : ask_bench(bench));
    });
  };
  if (is_decided_by_benches(true)) return;
  if (takes(
          ask(judges_.netlists.key(variant), [&] { return judges_.netlists.ask(variant, folder); }),
          outcome)) {
    return;
  }
  if (quick) return;
  const std::string comparison = outcome.by;
  const std::vector<Proof> proofs = judges_.proofs.proofs_of(unit.name);
  const auto is_killed_by_proofs = [&](bool are_own) {
    return std::ranges::any_of(proofs, [&](const Proof& proof) {
      return (proof.entity == unit.name) == are_own && ask_proof(proof);
    });
  };
  if (!is_killed_by_proofs(true) && !is_decided_by_benches(false) && !is_killed_by_proofs(false)) {
    outcome.by = comparison;
  }
}

}  // namespace proof
