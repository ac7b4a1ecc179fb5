// SPDX-License-Identifier: Apache-2.0
// The sources as they are, from which every judge takes only the files that its unit needs.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/proof/judged.hpp"
#include "tools/proof/source_tree.hpp"
#include "tools/proof/workspace.hpp"

namespace proof {

// For each call of a tool.
constexpr std::chrono::seconds wall_limit{1800};
constexpr std::chrono::seconds synthesis_limit{60};
constexpr std::chrono::seconds solver_limit{8};

class JudgedSources {
 public:
  // Weaves the sources into `work`.
  explicit JudgedSources(const Folders& folders);

  const SourceTree& simulated() const { return simulated_; }
  const SourceTree& synthesized() const { return synthesized_; }
  const std::filesystem::path& work() const { return work_; }

  // The unit itself, or for a package all entities of its folder that use it.
  std::vector<std::string> entities_of(const std::string& unit) const;

  // All that `top` needs, with the file `stand_in` in the place of `unit`.
  std::vector<std::string> files(const SourceTree& tree, const std::string& top,
                                 const std::string& unit, const std::string& stand_in) const;
  // Of the question `text` and everything that `top` needs, with the variant in its place.
  std::string key(const SourceTree& tree, const std::string& top, const std::string& text,
                  const Variant& variant) const;
  // Verilog of `top`; nothing where GHDL refuses it.
  std::optional<std::string> synthesize(const std::string& top, const std::string& unit,
                                        const std::string& stand_in,
                                        const std::map<std::string, std::string>& generics,
                                        const std::filesystem::path& folder) const;

 private:
  std::filesystem::path work_;
  SourceTree simulated_;
  SourceTree synthesized_;
};

// The end of what a tool has written.
std::string last_words(const std::filesystem::path& log);

}  // namespace proof
