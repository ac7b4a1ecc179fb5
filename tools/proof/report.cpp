// SPDX-License-Identifier: Apache-2.0
// Table lines and the names of the JSON file.
#include "tools/proof/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/files/write_text.hpp"

namespace proof {

namespace {

using Json = nlohmann::ordered_json;

std::string configuration_of(const Proof& proof) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : proof.generics) {
    parts.push_back(fmt::format("{} = {}", name, value));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string how(const Proof& proof) {
  switch (proof.method) {
    case Method::induction:
      return fmt::format("induction over {}", proof.depth);
    case Method::bounded:
      return fmt::format("bounded, {} clocks", proof.depth);
    case Method::arithmetic:
      return "arithmetic";
    case Method::sighting:
      return fmt::format("sighted in {} clocks", proof.depth);
    case Method::bench:
      return "bench";
  }
  return "";
}

Json json_of(const Trial& trial) {
  Json json{{"name", trial.name()}};
  if (trial.mutation) {
    json["file"] = trial.mutation->file.string();
    json["proof"] = trial.mutation->proof;
    json["property"] = trial.mutation->property;
    json["caught"] = trial.outcome.verdict == Verdict::holds;
  } else {
    json["says"] = trial.proof.says;
    json["entity"] = trial.proof.entity;
    json["generics"] = trial.proof.generics;
    json["method"] = name_of(trial.proof.method);
    if (trial.proof.depth != 0) json["depth_clocks"] = trial.proof.depth;
    if (trial.proof.method == Method::sighting) json["values"] = trial.proof.values;
    json["result"] = name_of(trial.outcome.verdict);
    json["properties"] = trial.outcome.asserted;
    json["assumptions"] = trial.outcome.assumed;
  }
  json["tried"] = trial.is_tried;
  json["failed"] = trial.outcome.failed;
  json["explanation"] = trial.outcome.explanation;
  json["seconds"] = trial.outcome.seconds;
  return json;
}

}  // namespace

void print_choice(const std::vector<Trial>& trials, std::optional<std::uint64_t> seed) {
  const auto recorded = std::ranges::count_if(trials, &Trial::is_recorded);
  const auto again = std::ranges::count_if(
      trials, [](const Trial& trial) { return trial.is_recorded && trial.is_tried; });
  fmt::print("{} of {} have a valid record; {} of these are tried again{}\n", recorded,
             trials.size(), again, seed ? fmt::format(", seed {}", *seed) : "");
  std::fflush(stdout);
}

void print_line(const Trial& trial) {
  const bool good = trial.outcome.verdict == Verdict::holds;
  if (trial.mutation) {
    fmt::print("{:9} mutation {:52} breaks {:42} {:6.1f} s\n", good ? "caught" : "NOT CAUGHT",
               trial.name(),
               trial.mutation->property.empty() ? trial.proof.name : trial.mutation->property,
               trial.outcome.seconds);
  } else {
    fmt::print("{:9} {:32} {:28} {:22} {:3} properties {:6.1f} s\n",
               good ? "holds" : name_of(trial.outcome.verdict), trial.name(),
               configuration_of(trial.proof), how(trial.proof), trial.outcome.asserted.size(),
               trial.outcome.seconds);
  }
  if (!good) fmt::print("  {}\n", trial.outcome.explanation);
  if (!good && trial.is_recorded) fmt::print("  its record says otherwise\n");
  std::fflush(stdout);
}

void print_summary(const std::vector<Trial>& trials, double seconds) {
  const auto count = [&trials](bool mutations, bool good) {
    return std::ranges::count_if(trials, [=](const Trial& trial) {
      return trial.mutation.has_value() == mutations &&
             (!good || trial.outcome.verdict == Verdict::holds);
    });
  };
  fmt::print("{} of {} proofs hold, {} of {} mutations are caught, {} of all by record, {:.1f} s\n",
             count(false, true), count(false, false), count(true, true), count(true, false),
             std::ranges::count_if(trials, [](const Trial& trial) { return !trial.is_tried; }),
             seconds);
}

void write_json(const std::filesystem::path& file, const std::vector<Trial>& trials,
                double seconds) {
  Json json{{"result", "holds"},
            {"seconds", seconds},
            {"proofs", Json::array()},
            {"mutations", Json::array()}};
  for (const Trial& trial : trials) {
    json[trial.mutation ? "mutations" : "proofs"].push_back(json_of(trial));
    if (trial.outcome.verdict != Verdict::holds) {
      if (trial.proof.method == Method::sighting) json["values"] = trial.proof.values;
      json["result"] = "fails";
    }
  }
  files::write_text(file, json.dump(2) + "\n");
}

}  // namespace proof
