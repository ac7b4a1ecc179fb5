// SPDX-License-Identifier: Apache-2.0
// Lines, tables and files.
#include "tools/proof/campaign_report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tools/files/write_text.hpp"
#include "tools/proof/campaign_summary.hpp"

namespace proof {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> units_of(const std::vector<MutantOutcome>& outcomes) {
  std::vector<std::string> units;
  for (const MutantOutcome& outcome : outcomes) {
    if (units.empty() || units.back() != outcome.unit) units.push_back(outcome.unit);
  }
  return units;
}

void print_row(const std::string& name, const Count& count, double seconds) {
  fmt::print("{:24} {:6} {:6} {:8} {:8} {:9} {:8.1f} % {:9.2f} s\n", name, count.counted(),
             count.killed, count.proved_equivalent, count.judged_equivalent, count.surviving,
             count.score() * 100, seconds);
}

Json json_of(const Count& count) {
  return {{"killed", count.killed},
          {"surviving", count.surviving},
          {"proved_equivalent", count.proved_equivalent},
          {"judged_equivalent", count.judged_equivalent},
          {"refused", count.refused},
          {"score", count.score()}};
}

double mean_seconds(const std::vector<MutantOutcome>& outcomes, const std::string& unit) {
  double sum = 0;
  int number = 0;
  for (const MutantOutcome& outcome : outcomes) {
    if (unit.empty() || outcome.unit == unit) {
      sum += outcome.seconds;
      ++number;
    }
  }
  return number == 0 ? 0 : sum / number;
}

}  // namespace

void print_progress(const MutantOutcome& outcome, std::size_t done, std::size_t all) {
  constexpr std::size_t interval = 100;
  if (outcome.fate == Fate::surviving) {
    fmt::print("SURVIVES{} ({}, {:.1f} s) {}\n", outcome.is_listed ? ", listed" : "", outcome.by,
               outcome.seconds, outcome.mutant.id);
  }
  if (done % interval == 0) fmt::print("{} of {} mutants tried\n", done, all);
  std::fflush(stdout);
}

void print_campaign(const std::vector<MutantOutcome>& outcomes,
                    const std::vector<std::string>& stale, double seconds) {
  fmt::print("{:24} {:>6} {:>6} {:>8} {:>8} {:>9} {:>10} {:>11}\n", "", "count", "killed",
             "proved=", "judged=", "surviving", "score", "each");
  for (const std::string& unit : units_of(outcomes)) {
    print_row(unit, count(outcomes, unit), mean_seconds(outcomes, unit));
  }
  const Count all = count(outcomes);
  print_row("all", all, mean_seconds(outcomes, ""));
  for (const std::string& entry : stale) {
    fmt::print("stale entry in testbench/proofs/mutants: {}\n", entry);
  }
  fmt::print("{} mutants, {} of them refused by compiler or synthesis and not counted, {:.1f} s\n",
             outcomes.size(), all.refused, seconds);
}

void write_campaign(const std::filesystem::path& file, const std::vector<MutantOutcome>& outcomes,
                    const std::vector<std::string>& stale, bool good, double seconds) {
  Json json{{"result", good ? "good" : "not good"},
            {"seconds", seconds},
            {"all", json_of(count(outcomes))},
            {"files", Json::object()},
            {"stale", stale},
            {"mutants", Json::array()}};
  for (const std::string& unit : units_of(outcomes)) {
    json["files"][unit] = json_of(count(outcomes, unit));
  }
  for (const MutantOutcome& outcome : outcomes) {
    json["mutants"].push_back({{"mutant", outcome.mutant.id},
                               {"operator", outcome.mutant.kind},
                               {"fate", name_of(outcome.fate)},
                               {"by", outcome.by},
                               {"seconds", outcome.seconds}});
  }
  files::write_text(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

namespace {

// What killed it, or which judges it has survived: those of equivalence depend on the
// machine's speed.
std::string recorded_by(const MutantOutcome& outcome) {
  if (outcome.fate == Fate::surviving) {
    return outcome.is_quick ? "its own and short benches, the comparison" : "all judges";
  }
  return outcome.fate == Fate::killed ? outcome.by : "";
}

// The lines of a list, by the mutant that each ends with.
std::map<std::string, std::string> lines_by_mutant(const std::filesystem::path& list) {
  std::map<std::string, std::string> lines;
  std::ifstream stream(list);
  for (std::string line; std::getline(stream, line);) {
    lines[line.substr(line.rfind('\t') + 1)] = line;
  }
  return lines;
}

}  // namespace

void record_campaign(const std::filesystem::path& folder,
                     const std::vector<MutantOutcome>& outcomes,
                     const std::vector<std::string>& made, bool keeps_others) {
  std::filesystem::create_directories(folder);
  std::map<std::string, const MutantOutcome*> tried;
  for (const MutantOutcome& outcome : outcomes) tried[outcome.mutant.id] = &outcome;
  const std::vector<std::string> units = units_of(outcomes);
  std::set<std::string> to_write(units.begin(), units.end());
  for (const std::string& id : made) {
    const std::string unit = id.substr(0, id.find(':'));
    if (!exists(folder / (unit + ".tsv"))) to_write.insert(unit);
  }
  for (const std::string& unit : to_write) {
    const auto earlier = keeps_others ? lines_by_mutant(folder / (unit + ".tsv"))
                                      : std::map<std::string, std::string>{};
    std::string text;
    for (const std::string& id : made) {
      if (!id.starts_with(unit + ": ")) continue;
      if (const auto line = earlier.find(id); line != earlier.end() && !tried.contains(id)) {
        text += line->second + "\n";
        continue;
      }
      const auto found = tried.find(id);
      text += fmt::format("{}\t{}\t{}\n",
                          found == tried.end() ? not_tried : name_of(found->second->fate),
                          found == tried.end() ? "" : recorded_by(*found->second), id);
    }
    files::write_text(folder / (unit + ".tsv"), text);
  }
  write_summary(folder);
}

std::set<std::string> mutants_listed_as(const std::string& fate,
                                        const std::filesystem::path& folder) {
  std::set<std::string> ids;
  if (!exists(folder)) return ids;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".tsv") continue;
    for (const auto& [id, line] : lines_by_mutant(file.path())) {
      if (line.starts_with(fate + "\t")) ids.insert(id);
    }
  }
  return ids;
}

}  // namespace proof
