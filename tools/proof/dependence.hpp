// SPDX-License-Identifier: Apache-2.0
// A digest of everything that the verdict of a trial depends on: if it is the same, so is
// the verdict.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tools/proof/list.hpp"
#include "tools/proof/source_tree.hpp"
#include "tools/proof/workspace.hpp"

namespace proof {

// The versions of the tools.
struct Versions {
  std::string ghdl, yosys, z3;
};

// Throws std::runtime_error if a tool is missing. Their logs go into the folder.
Versions versions_of_tools(const std::filesystem::path& folder);

// The text of a VHDL file without what cannot change a netlist: comments, unless one of them could
// be an instruction to a tool, and space.
std::string essence_of(std::string_view vhdl);

// The text of tools/proof/task.cpp and of all in tools/proof that it includes, from each header to
// its .cpp: what takes the steps from sources to verdict, with the options of every tool. Not that
// of the libraries which read files and start processes: they have tests of their own.
std::string text_of_the_judge(const std::filesystem::path& project);

class Dependence {
 public:
  // Weaves the project's sources into `folders.work`, for both purposes.
  Dependence(const Folders& folders, const Versions& versions);

  // Of a proof, or of the mutation of it. Nothing if the sources or the mutation are invalid: a
  // trial reports why.
  std::optional<std::string> digest_of(const Proof& proof, const Mutation* mutation) const;

 private:
  // Sources woven for one purpose, and the digests of their essences.
  struct Woven {
    SourceTree tree;
    std::map<std::string, std::string> digests;
  };
  static Woven woven(const Folders& folders, const char* name, Purpose purpose);
  std::string of_sources(const Proof& proof, const Mutation* mutation) const;
  std::string of_lemma(const Proof& proof, const Mutation* mutation) const;

  Folders folders_;
  Versions versions_;
  std::string judge_;
  Woven synthesized_;
  Woven simulated_;
};

}  // namespace proof
