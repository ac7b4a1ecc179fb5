// SPDX-License-Identifier: Apache-2.0
// groups/NAME.toml: figures that one call measures, and where they stand in what it leaves.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace figures {

struct Group {
  std::string name;
  std::string about;  // a sentence for the list of all groups
  std::vector<std::string> build;  // what is built before
  std::vector<std::string> command;  // with {stepfabric}, {bin}, {build}, {folder}, {result}
  std::string result;  // a JSON file in {folder}; empty: what it says only
  int highest_status{};  // of the command's exit; a higher one is a failure
  int minutes{};  // that it takes on a machine with nothing else to do
  bool of_machine{};  // another machine gives other figures
  std::map<std::string, std::string> paths;  // name of a value: where it is in the result
  std::map<std::string, std::string> pictures;  // file in {folder}: where it goes in the project
  std::map<std::string, std::string> matches;  // name: regular expression for what it says

  // The call as a person writes it.
  std::string command_text() const;
  bool has_value(const std::string& value) const {
    return paths.contains(value) || matches.contains(value);
  }
};

// Throws std::runtime_error, with the file, where an entry is missing or is none of these.
Group read_group(const std::filesystem::path& file);
// All of a folder, by name.
std::map<std::string, Group> read_groups(const std::filesystem::path& folder);

// `text` with the value in the place of each {NAME}.
std::string filled_in(std::string text, const std::map<std::string, std::string>& values);

}  // namespace figures
