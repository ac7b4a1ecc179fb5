// SPDX-License-Identifier: Apache-2.0
// Reading TOML; every entry is known or refused.
#include "tools/figures/group.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <toml++/toml.hpp>

namespace figures {

namespace {

std::vector<std::string> words_of(const toml::table& table, const char* name) {
  std::vector<std::string> words;
  if (const toml::array* array = table[name].as_array()) {
    for (const toml::node& node : *array) words.push_back(node.value<std::string>().value());
  }
  return words;
}

std::map<std::string, std::string> texts_of(const toml::table& table, const char* name) {
  std::map<std::string, std::string> texts;
  if (const toml::table* entries = table[name].as_table()) {
    for (const auto& [key, node] : *entries) {
      texts[std::string(key.str())] = node.value<std::string>().value();
    }
  }
  return texts;
}

void refuse_unknown_entries(const toml::table& table) {
  const std::set<std::string_view> known{"about",          "build",   "command",    "result",
                                         "highest_status", "minutes", "of_machine", "values",
                                         "matches",        "pictures"};
  for (const auto& [key, node] : table) {
    if (!known.contains(key.str())) {
      throw std::runtime_error(fmt::format("{} is no entry of a group", key.str()));
    }
  }
}

}  // namespace

std::string filled_in(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [name, value] : values) {
    const std::string wanted = "{" + name + "}";
    for (std::size_t at = 0; (at = text.find(wanted, at)) != std::string::npos;
         at += value.size()) {
      text.replace(at, wanted.size(), value);
    }
  }
  return text;
}

std::string Group::command_text() const {
  return filled_in(fmt::format("{}", fmt::join(command, " ")), {{"stepfabric", "./stepfabric"},
                                                                {"bin", "build/bin"},
                                                                {"build", "build"},
                                                                {"folder", "FOLDER"},
                                                                {"result", "FILE"}});
}

Group read_group(const std::filesystem::path& file) {
  try {
    const toml::table table = toml::parse_file(file.string());
    refuse_unknown_entries(table);
    Group group{.name = file.stem().string(),
                .about = table["about"].value<std::string>().value(),
                .build = words_of(table, "build"),
                .command = words_of(table, "command"),
                .result = table["result"].value_or(""),
                .highest_status = table["highest_status"].value_or(0),
                .minutes = table["minutes"].value<int>().value(),
                .of_machine = table["of_machine"].value_or(false),
                .paths = texts_of(table, "values"),
                .pictures = texts_of(table, "pictures"),
                .matches = texts_of(table, "matches")};
    if (group.command.empty() || (group.paths.empty() && group.matches.empty())) {
      throw std::runtime_error("a group needs a command and values");
    }
    return group;
  } catch (const std::bad_optional_access&) {
    throw std::runtime_error(fmt::format("{}: about, minutes or a text is missing", file.string()));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::map<std::string, Group> read_groups(const std::filesystem::path& folder) {
  std::map<std::string, Group> groups;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") {
      Group group = read_group(entry.path());
      groups[group.name] = group;
    }
  }
  return groups;
}

}  // namespace figures
