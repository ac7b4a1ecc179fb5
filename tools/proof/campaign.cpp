// SPDX-License-Identifier: Apache-2.0
// Generates the mutants, tries them on several processor cores, and caches the verdicts.
#include "tools/proof/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "tools/proof/campaign_report.hpp"
#include "tools/proof/cascade.hpp"
#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

std::vector<Unit> units_of(const fs::path& project) {
  std::vector<Unit> units;
  for (const char* folder : {"motion", "thermal"}) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(project / "rtl" / folder)) {
      if (entry.path().extension() == ".vhd") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) units.push_back({file.stem().string(), text_of(file)});
  }
  return units;
}

// Of the packages that a unit uses itself.
std::vector<std::string> constants_near(const SourceTree& sources, const std::string& unit) {
  std::vector<std::string> constants;
  for (const std::string& name : sources.needs_of(unit)) {
    if (name.ends_with("_pkg") && sources.has(name)) {
      const std::vector<std::string> more = constants_of(sources.text_of(name));
      constants.insert(constants.end(), more.begin(), more.end());
    }
  }
  return constants;
}

struct Task {
  const Unit* unit;
  Mutant mutant;
};

}  // namespace

bool run_campaign(const CampaignOptions& options, const fs::path& project, const fs::path& build) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Unit> units = units_of(project);
  const auto is_asked_for = [&options](const Unit& unit) {
    return options.units.empty() ||
           std::ranges::any_of(options.units, [&unit](const std::string& name) {
             return fs::path(name).stem() == unit.name;
           });
  };
  for (const std::string& name : options.units) {
    if (std::ranges::none_of(
            units, [&name](const Unit& unit) { return fs::path(name).stem() == unit.name; })) {
      throw std::runtime_error(
          fmt::format("{} is neither a file of rtl/motion or rtl/thermal nor an entity", name));
    }
  }
  const fs::path lists = Folders{project, {}}.list() / "mutants";
  const bool is_part = options.untried || options.surviving;
  // Those alone, or all but those.
  std::set<std::string> listed;
  if (options.recorded || options.untried) listed = mutants_listed_as(not_tried, lists);
  if (options.surviving) listed.merge(mutants_listed_as(name_of(Fate::surviving), lists));
  std::vector<Task> tasks;
  std::vector<std::string> made;
  std::string contents;
  const SourceTree sources({project / "rtl"});
  for (const Unit& unit : units) {
    for (Mutant& mutant : mutants_of(unit.text, unit.name, constants_near(sources, unit.name))) {
      made.push_back(mutant.id);
      if (is_asked_for(unit) && listed.contains(mutant.id) == is_part) {
        tasks.push_back({&unit, std::move(mutant)});
      }
    }
    contents += is_asked_for(unit) ? unit.text : "";
  }
  constexpr int hexadecimal = 16;
  const std::uint64_t seed =
      options.seed.value_or(std::stoull(fingerprint(contents).substr(0, 16), nullptr, hexadecimal));
  const std::vector<std::size_t> chosen =
      sample_of(tasks.size(), static_cast<std::size_t>(options.sample), seed);
  const bool is_sample = chosen.size() < tasks.size();

  const fs::path work = fs::absolute(build) / "mutants";
  const Folders folders{project, work / "sources"};
  fs::create_directories(folders.work);
  const std::map<std::string, Judgement> judgements = read_judgements(lists);
  Judges judges(folders, read_list(folders.list()));
  Findings findings(work / "findings.txt");
  Cascade cascade(judges, findings);

  std::vector<MutantOutcome> outcomes(chosen.size());
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::string failure;
  std::mutex terminal;
  const auto run = [&](unsigned worker) {
    const fs::path folder = work / fmt::format("worker_{}", worker);
    fs::create_directories(folder);
    for (std::size_t i = next++; i < chosen.size(); i = next++) {
      const Task& task = tasks[chosen[i]];
      const auto judgement = judgements.find(task.mutant.id);
      try {
        // A sample is to be quick, and listed mutants may survive: the other checks are for a
        // whole campaign.
        const bool quick = options.quick || (is_sample && judgement != judgements.end());
        outcomes[i] = cascade.try_mutant(*task.unit, task.mutant, folder, quick);
      } catch (const std::exception& error) {
        const std::scoped_lock lock(terminal);
        failure = fmt::format("{}: {}", task.mutant.id, error.what());
        next = chosen.size();
        return;
      }
      if (judgement != judgements.end() && outcomes[i].fate == Fate::surviving) {
        outcomes[i].is_listed = true;
        if (judgement->second.kind == Judgement::Kind::equivalent) {
          outcomes[i].fate = Fate::judged_equivalent;
        }
      }
      const std::scoped_lock lock(terminal);
      print_progress(outcomes[i], ++done, chosen.size());
    }
  };
  const unsigned jobs =
      options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < jobs; ++i) workers.emplace_back(run, i);
  }
  if (!failure.empty()) throw std::runtime_error(failure);

  const std::vector<std::string> stale = stale_entries(judgements, made, outcomes);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const bool good = is_good(outcomes, stale, is_sample);
  print_campaign(outcomes, stale, seconds);
  if (!options.json.empty()) write_campaign(options.json, outcomes, stale, good, seconds);
  if (options.record) record_campaign(lists, outcomes, made, is_part);
  return good;
}

}  // namespace proof
