// SPDX-License-Identifier: Apache-2.0
// The instructions of one function and the ways between them, as far as the code alone shows.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "sim/processor/decoder.hpp"
#include "tools/timing/program.hpp"

namespace timing {

enum class End { none, returns, goes_on_elsewhere, halts };

struct Way {
  std::size_t to{};
  bool taken = false;  // of branches
};

struct Node {
  Address address{};
  processor::Instruction instruction;
  bool calls = false;  // its ways begin where the called function has returned
  End end = End::none;  // without ways: what becomes of the path
  std::vector<Way> ways;
};

struct Flow {
  std::vector<Node> nodes;  // the first is the function's start
};

// A function, and the register that holds where it returns to: calls of the common code that saves
// registers (-msave-restore) use another than all others.
struct Entry {
  Address address{};
  unsigned link = 1;
  auto operator<=>(const Entry&) const = default;
};

class Flows {
 public:
  explicit Flows(const Program& program, bool has_zbb = false)
      : program_(program), has_zbb_(has_zbb) {}

  // Throws Unbounded where functions call each other.
  const Flow& of(Entry entry);
  // Whether a path leads back to the caller.
  bool returns(Entry entry);

  processor::Instruction at(Address address) const;

 private:
  bool returns(Entry entry, std::set<Address>& asked);
  Flow explore(Entry entry);
  bool is_other_function(Address target, Entry entry) const;

  const Program& program_;
  bool has_zbb_;
  std::map<Entry, Flow> flows_;
  std::set<Entry> under_way_;
};

// In all the code: nothing where no interrupt ever runs code. Bounds hold for such programs only.
std::optional<Address> place_that_enables_interrupts(const Program& program, bool has_zbb);
// Throws std::runtime_error where there is one.
void refuse_interrupts(const Program& program, bool has_zbb);

}  // namespace timing
