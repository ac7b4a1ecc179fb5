// SPDX-License-Identifier: Apache-2.0
// [[equivalent]] and [[surviving]], each with `mutant` (or `mutants`, an array) and `reason`.
#include "tools/proof/mutant_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <toml++/toml.hpp>

namespace proof {

namespace {

void read_entry(const std::string& file, const toml::table& entry, Judgement::Kind kind,
                std::map<std::string, Judgement>& judgements) {
  const auto reason = entry["reason"].value<std::string>();
  const toml::array* mutants = entry["mutants"].as_array();
  if (!reason || reason->empty() || mutants == nullptr || mutants->empty() || entry.size() != 2) {
    throw std::runtime_error(
        fmt::format("{}: line {}: an entry is `mutants`, an array of ids, and `reason`", file,
                    entry.source().begin.line));
  }
  for (const toml::node& node : *mutants) {
    const auto mutant = node.value<std::string>();
    if (!mutant) {
      throw std::runtime_error(fmt::format("{}: `mutants` must be an array of ids", file));
    }
    if (!judgements.emplace(*mutant, Judgement{kind, *reason}).second) {
      throw std::runtime_error(fmt::format("{}: stands there twice: {}", file, *mutant));
    }
  }
}

}  // namespace

std::map<std::string, Judgement> read_judgements(const std::filesystem::path& folder) {
  std::map<std::string, Judgement> judgements;
  if (!exists(folder)) return judgements;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".toml") continue;
    const std::string name = file.path().filename().string();
    toml::table table;
    try {
      table = toml::parse_file(file.path().string());
    } catch (const toml::parse_error& error) {
      throw std::runtime_error(
          fmt::format("{}: line {}: {}", name, error.source().begin.line, error.description()));
    }
    for (const auto& [key, value] : table) {
      const bool is_equivalent = key.str() == "equivalent";
      if ((!is_equivalent && key.str() != "surviving") || !value.is_array_of_tables()) {
        throw std::runtime_error(
            fmt::format("{}: must hold [[equivalent]] and [[surviving]] alone", name));
      }
      for (const toml::node& entry : *value.as_array()) {
        read_entry(name, *entry.as_table(),
                   is_equivalent ? Judgement::Kind::equivalent : Judgement::Kind::surviving,
                   judgements);
      }
    }
  }
  return judgements;
}

}  // namespace proof
