// SPDX-License-Identifier: Apache-2.0
// Folders in which proofs are tried, and the way of the sources to the solver's input.
#pragma once

#include <filesystem>

#include "tools/proof/formal_netlist.hpp"
#include "tools/proof/list.hpp"
#include "tools/proof/source_tree.hpp"

namespace proof {

struct Folders {
  std::filesystem::path project;
  std::filesystem::path work;  // is emptied

  std::filesystem::path list() const { return project / "testbench" / "proofs"; }
};

// Empties `work` and copies all that trials read of the project into it: what is changed while they
// go on must not be taken for what it was.
Folders copied(const std::filesystem::path& project, const std::filesystem::path& work);

// What the sources are for: not all properties can be simulated.
enum class Purpose { solver, simulator };

// Writes the file of the mutation with the fault in it.
void write_mutated(const Folders& folders, const Mutation& mutation,
                   const std::filesystem::path& copy);

// Copies the chip's sources to `sources`, with the properties woven into them; with
// a mutation first.
void prepare_sources(const Folders& folders, const std::filesystem::path& sources,
                     const Mutation* mutation, Purpose purpose = Purpose::solver);

// Puts files of the folder of all lists in the place of the sources of the same name. Throws
// std::runtime_error where there is no such source, or no such file.
void put_in_place(const std::filesystem::path& lists,
                  const std::vector<std::filesystem::path>& stand_ins, SourceTree& tree);

// Analyses what `unit`, an entity, needs and nothing else, and returns GHDL's library. Stand-ins
// as in `Proof`.
std::filesystem::path analyse(const Folders& folders, const std::filesystem::path& sources,
                              const std::vector<std::filesystem::path>& stand_ins,
                              const std::string& unit, const std::filesystem::path& folder);

struct SolverInput {
  std::filesystem::path file;
  FormalNetlist netlist;
};

// The proof's entity as SMT-LIB in `folder`, with the one property or those that the proof is for.
// Throws std::runtime_error with the tool's last words.
SolverInput make_solver_input(const Folders& folders, const std::filesystem::path& sources,
                              const Proof& proof, const std::string* property,
                              const std::filesystem::path& folder);

}  // namespace proof
