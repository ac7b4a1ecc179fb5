// SPDX-License-Identifier: Apache-2.0
// Judges mutants by comparison with the original netlist.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "tools/proof/judged_sources.hpp"
#include "tools/proof/list.hpp"

namespace proof {

class NetlistJudge {
 public:
  NetlistJudge(const JudgedSources& sources, const List& list) : sources_(sources), list_(list) {}

  // Equivalent, refused, or passes where that is not found. `folder` is for this call alone.
  Judged ask(const Variant& variant, const std::filesystem::path& folder);

  // Everything that the answer depends on, with the variant in its place.
  std::string key(const Variant& variant) const;

 private:
  struct Original {
    std::once_flag once;
    std::string netlist;  // file
    std::string verilog;
  };
  // Those of a proof of the entity that has some, because a small memory is compared in seconds.
  std::map<std::string, std::string> compared_generics(const std::string& entity) const;
  // Which properties are proved of an entity with these generics, for all times.
  std::optional<Choice> invariants_of(const std::string& entity) const;
  std::string write_netlist(const std::string& verilog, const std::string& entity, const char* name,
                            const std::filesystem::path& folder) const;
  const Original& original(const std::string& entity);
  Judged compare_in(const std::string& entity, const Variant& variant,
                    const std::filesystem::path& folder);

  const JudgedSources& sources_;
  List list_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<Original>> originals_;
};

}  // namespace proof
