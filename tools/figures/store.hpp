// SPDX-License-Identifier: Apache-2.0
// figures.json: what was measured, with which command, when,
// and where that matters on what machine.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace figures {

struct Record {
  std::string command;
  std::string measured;  // the day, YYYY-MM-DD
  std::string machine;  // empty where the figures are the same on every machine
  std::map<std::string, double> values;

  bool operator==(const Record&) const = default;
};

using Store = std::map<std::string, Record>;  // by the name of the group

// Throws std::runtime_error, with the file, where it cannot be read or is not of this form.
Store read_store(const std::filesystem::path& file);
std::string to_json(const Store& store);

}  // namespace figures
