// SPDX-License-Identifier: Apache-2.0
// The stack that a function takes, with all that it calls.
#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "tools/timing/call_tree.hpp"
#include "tools/timing/reach.hpp"

namespace timing {

class Stack {
 public:
  explicit Stack(const Program& program, bool has_zbb = false);

  // Bytes below the stack pointer that the function is called with; nothing where there are
  // problems. Nothing is known of its arguments.
  std::optional<std::uint32_t> depth(Address function);
  // Of main; where ticks of software stepping interrupt it (firmware/software_stepping/tick.S),
  // with the deepest of them, which do not interrupt each other.
  std::optional<std::uint32_t> of_image();
  const std::set<Problem>& problems() const { return tree_.problems(); }

 private:
  std::optional<std::uint32_t> depth(Entry entry, const State& at_call);
  std::optional<std::uint32_t> measure(Entry entry, const State& start);
  Problem problem(Entry entry, Address address, const char* what, const char* remedy) const;

  const Program& program_;
  Flows flows_;
  Reach reach_;
  CallTree<std::uint32_t> tree_;
};

}  // namespace timing
