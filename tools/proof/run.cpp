// SPDX-License-Identifier: Apache-2.0
// Chooses what is tried, and runs it on several threads.
#include "tools/proof/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tools/files/path_lock.hpp"
#include "tools/proof/dependence.hpp"
#include "tools/proof/records.hpp"
#include "tools/proof/report.hpp"

namespace proof {

namespace {

const Proof& proof_named(const List& list, const std::string& name) {
  return *std::ranges::find_if(list.proofs,
                               [&name](const Proof& proof) { return proof.name == name; });
}

std::vector<Trial> chosen(const Options& options, const List& list) {
  const auto is_asked_for = [&options](const std::string& name) {
    return options.names.empty() || std::ranges::find(options.names, name) != options.names.end();
  };
  std::vector<Trial> trials;
  for (const Proof& proof : list.proofs) {
    if (options.proofs && is_asked_for(proof.name) && (proof.quick || !options.quick)) {
      trials.push_back({.proof = proof});
    }
  }
  for (const Mutation& mutation : list.mutations) {
    if (options.mutations && !options.quick && is_asked_for(mutation.name)) {
      trials.push_back({.proof = proof_named(list, mutation.proof), .mutation = mutation});
    }
  }
  for (const std::string& name : options.names) {
    if (std::ranges::none_of(trials,
                             [&name](const Trial& trial) { return trial.name() == name; })) {
      throw std::runtime_error(fmt::format("no proof or mutation {} is to be tried", name));
    }
  }
  if (trials.empty()) throw std::runtime_error("nothing is to be tried");
  return trials;
}

// Whether records count: not if trials are requested by name or with other settings.
bool trusts_records(const Options& options) {
  return options.names.empty() && !options.quick && !options.all;
}

std::uint64_t seed_of(const Options& options) {
  if (options.seed) return *options.seed;
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  return static_cast<std::uint64_t>(today.time_since_epoch().count());
}

// Decides which trials can be skipped by their records.
void spare_recorded(const Options& options, const std::vector<std::string>& part,
                    const Records& records, std::vector<Trial>& trials) {
  for (Trial& trial : trials) {
    const auto record = records.find(trial.name());
    trial.is_recorded = trial.digest && record != records.end() &&
                        record->second == Record{trial.recorded_outcome(), *trial.digest};
    trial.is_tried = !trial.is_recorded || !trusts_records(options) ||
                     std::ranges::find(part, trial.name()) != part.end();
    if (!trial.is_tried) trial.outcome.verdict = Verdict::holds;
  }
}

std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const Proof& proof : list.proofs) names.push_back(proof.name);
  for (const Mutation& mutation : list.mutations) names.push_back(mutation.name);
  return names;
}

// The table, as long as trials are made: each outcome is written at once.
class Keeper {
 public:
  Keeper(std::filesystem::path file, const List& list)
      : file_(std::move(file)), records_(read_records(file_)) {
    const std::vector<std::string> names = names_of(list);
    std::erase_if(records_, [&names](const auto& row) {
      return std::ranges::find(names, row.first) == names.end();
    });
  }

  void keep(const Trial& trial) {
    records_.erase(trial.name());
    if (trial.digest && trial.outcome.verdict == Verdict::holds) {
      records_[trial.name()] = {trial.recorded_outcome(), *trial.digest};
    }
    write();
  }
  void write() const { write_records(file_, records_); }

 private:
  std::filesystem::path file_;
  Records records_;
};

// Tries on several processor cores and hands over each trial when it is done, one at a time.
template <typename Done>
void try_all(const Folders& folders, const Options& options, std::vector<Trial>& trials,
             const Done& done) {
  const std::filesystem::path sources = folders.work / "sources";
  prepare_sources(folders, sources, nullptr);
  const std::chrono::seconds limit(options.limit_seconds);
  std::atomic<std::size_t> next = 0;
  std::mutex one_at_a_time;
  const auto work = [&] {
    for (std::size_t i = next++; i < trials.size(); i = next++) {
      Trial& trial = trials[i];
      if (!trial.is_tried) continue;
      trial.outcome = trial.mutation ? try_mutation(folders, *trial.mutation, trial.proof, limit)
                                     : try_proof(folders, trial.proof, sources, limit);
      const std::scoped_lock lock(one_at_a_time);
      done(trial);
    }
  };
  const unsigned jobs =
      options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < jobs; ++i) workers.emplace_back(work);
}

}  // namespace

bool prove(const Options& options, const std::filesystem::path& project,
           const std::filesystem::path& build) {
  // Another run would remove the files on which this one's trials are working.
  const files::PathLock lock(build / (options.mutants ? "mutants" : "proofs"),
                             "wait for its end, or use another build folder");
  if (options.mutants) {
    CampaignOptions campaign = options.campaign;
    campaign.units = options.names;
    campaign.sample = options.sample;
    campaign.seed = options.seed;
    campaign.record = options.record;
    campaign.json = options.json;
    campaign.jobs = options.jobs;
    campaign.quick = options.quick;
    return run_campaign(campaign, project, build);
  }
  const auto start = std::chrono::steady_clock::now();
  const Folders folders = copied(project, build / "proofs");
  const List list = read_list(Folders{project, {}}.list());
  std::vector<Trial> trials = chosen(options, list);
  const std::filesystem::path table = Folders{project, {}}.list() / "recorded.tsv";
  if (options.record || trusts_records(options)) {
    const Dependence dependence(folders, versions_of_tools(folders.work));
    for (Trial& trial : trials) {
      trial.digest = dependence.digest_of(trial.proof, trial.mutation ? &*trial.mutation : nullptr);
    }
    const std::uint64_t seed = seed_of(options);
    spare_recorded(options, part_of(names_of(list), static_cast<std::size_t>(options.sample), seed),
                   read_records(table), trials);
    print_choice(trials, options.sample == 0 ? std::nullopt : std::optional(seed));
  }
  std::optional<Keeper> keeper;
  if (options.record) keeper.emplace(table, list);
  if (keeper) keeper->write();
  try_all(folders, options, trials, [&keeper](const Trial& trial) {
    print_line(trial);
    if (keeper) keeper->keep(trial);
  });

  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  print_summary(trials, seconds);
  if (!options.json.empty()) write_json(options.json, trials, seconds);
  return std::ranges::all_of(
      trials, [](const Trial& trial) { return trial.outcome.verdict == Verdict::holds; });
}

}  // namespace proof
