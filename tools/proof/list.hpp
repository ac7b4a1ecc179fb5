// SPDX-License-Identifier: Apache-2.0
// What is to be proved, and the faults by which the proofs show that they bite.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace proof {

enum class Method {
  induction,  // for any number of clocks: the first `depth` by trying all, the rest by induction
  // over `depth`
  bounded,  // the first `depth` clocks after the start, whatever the inputs
  arithmetic,  // a statement about numbers, without clocks
  sighting,  // no proof either: that signals take so many values, so that what is said of these
  // is said of something
  bench,  // no proof: a test bench, for mutations of what no solver can follow
};

// One entity with one choice of generics.
struct Proof {
  std::string name;
  std::string says;
  Method method{};
  int depth{};  // clocks; without meaning for arithmetic and benches
  std::string entity;  // or the bench
  std::map<std::string, std::string> generics;
  std::vector<std::string> only;  // properties; all of the netlist where empty
  std::vector<std::string> except;  // properties that another proof is for
  std::vector<std::string>
      free;  // entities within, of which nothing is known: their outputs are free
  // Files relative to the folder of all lists: each takes the place of the source with its name
  // before the dot.
  std::vector<std::filesystem::path> stand_ins;
  // Copies of a generate statement, as "LABEL_n2", of which nothing is known and nothing is proved.
  std::vector<std::string> free_copies;
  // Of a sighting: signals as the flattened netlist names them, zero before they are sighted, and
  // how many other values they have together within `depth` clocks after the start.
  std::vector<std::string> signals;
  int values{};
  std::filesystem::path lemma;  // SMT-LIB file of an arithmetic proof, relative to the folder
  bool quick{};
};

// A fault put into a copy of the sources, which must break one property, or make a bench, a
// sighting or the lemma that it is put into fail.
struct Mutation {
  std::string name;
  std::filesystem::path list;  // where this stands
  std::filesystem::path file;  // relative to the project
  std::string from;  // occurs exactly once in the file
  std::string to;
  std::string proof;
  std::string property;  // empty where `proof` has none to choose from
  int depth{};  // clocks within which it must show
};

struct List {
  std::vector<Proof> proofs;
  std::vector<Mutation> mutations;
};

// Reads the files GROUP/proofs/*.toml and GROUP/mutations/*.toml of a folder. Throws
// std::runtime_error naming the file and the entry at fault: unknown keys, names given twice, a
// mutation of an unknown proof.
List read_list(const std::filesystem::path& folder);

const char* name_of(Method method);

}  // namespace proof
