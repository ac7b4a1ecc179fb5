// SPDX-License-Identifier: Apache-2.0
// Choice of what is tried, and the threads that do it.
#include "tools/proof/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

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
      trials.push_back({proof, std::nullopt, {}});
    }
  }
  for (const Mutation& mutation : list.mutations) {
    if (options.mutations && !options.quick && is_asked_for(mutation.name)) {
      trials.push_back({proof_named(list, mutation.proof), mutation, {}});
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

}  // namespace

bool prove(const Options& options, const std::filesystem::path& project,
           const std::filesystem::path& build) {
  if (options.mutants) {
    CampaignOptions campaign = options.campaign;
    campaign.units = options.names;
    campaign.json = options.json;
    campaign.jobs = options.jobs;
    campaign.quick = options.quick;
    return run_campaign(campaign, project, build);
  }
  const auto start = std::chrono::steady_clock::now();
  const Folders folders{project, build / "proofs"};
  std::vector<Trial> trials = chosen(options, read_list(folders.list()));
  std::filesystem::remove_all(folders.work);
  std::filesystem::create_directories(folders.work);
  const std::filesystem::path sources = folders.work / "sources";
  prepare_sources(folders, sources, nullptr);

  const std::chrono::seconds limit(options.limit_seconds);
  std::atomic<std::size_t> next = 0;
  std::mutex terminal;
  const auto work = [&] {
    for (std::size_t i = next++; i < trials.size(); i = next++) {
      Trial& trial = trials[i];
      trial.outcome = trial.mutation ? try_mutation(folders, *trial.mutation, trial.proof, limit)
                                     : try_proof(folders, trial.proof, sources, limit);
      const std::scoped_lock lock(terminal);
      print_line(trial);
    }
  };
  const unsigned jobs =
      options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < jobs; ++i) workers.emplace_back(work);
  }

  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  print_summary(trials, seconds);
  if (!options.json.empty()) write_json(options.json, trials, seconds);
  return std::ranges::all_of(
      trials, [](const Trial& trial) { return trial.outcome.verdict == Verdict::holds; });
}

}  // namespace proof
