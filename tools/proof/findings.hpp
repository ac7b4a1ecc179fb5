// SPDX-License-Identifier: Apache-2.0
// Verdicts of judges, cached in a file by a digest of everything that they depend on, so that
// nothing is tried twice. A verdict that a time limit cut short holds for this run only.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "tools/proof/judged.hpp"

namespace proof {

class Findings {
 public:
  explicit Findings(const std::filesystem::path& file);

  std::optional<Judged> find(const std::string& key);
  // Written at once: an interrupted campaign goes on where it was.
  void add(const std::string& key, const Judged& judged);

 private:
  std::mutex mutex_;
  std::map<std::string, Judged> known_;
  std::ofstream file_;
};

}  // namespace proof
