// SPDX-License-Identifier: Apache-2.0
// The lowest stack pointer of a function's instructions, and below it what is called there.
#include "tools/timing/stack.hpp"

#include <algorithm>

#include "tools/timing/callees.hpp"

namespace timing {

namespace {

std::uint32_t above_zero(std::int32_t bytes) {
  return static_cast<std::uint32_t>(std::max(bytes, 0));
}

// Interrupts of software stepping store below the stack pointer before they move it.
std::int32_t stored_below(const processor::Instruction& instruction, const State& before) {
  const Value base = before.registers[instruction.first];
  if (!is_store(instruction.operation) || base.base != stack_pointer) return 0;
  return static_cast<std::int32_t>(-(base.offset + instruction.immediate));
}

}  // namespace

Stack::Stack(const Program& program, bool has_zbb)
    : program_(program), flows_(program, has_zbb), reach_(program, flows_), tree_(program) {}

std::optional<std::uint32_t> Stack::depth(Address function) {
  return depth(entry_of(program_, function), State::at_start());
}

std::optional<std::uint32_t> Stack::of_image() {
  std::uint32_t interrupt = 0;
  for (const char* name : {"attend", "end_pulse_and_attend"}) {
    const auto place = program_.addresses.find(name);
    if (place == program_.addresses.end()) continue;
    const auto bytes = depth(place->second);
    if (!bytes) return std::nullopt;
    interrupt = std::max(interrupt, *bytes);
  }
  const auto main = program_.addresses.find("main");
  const auto bytes = main == program_.addresses.end() ? std::nullopt : depth(main->second);
  if (!bytes) return std::nullopt;
  return *bytes + interrupt;
}

std::optional<std::uint32_t> Stack::depth(Entry entry, const State& at_call) {
  return tree_.of(entry, at_call,
                  [&](Entry begun, const State& start) { return measure(begun, start); });
}

Problem Stack::problem(Entry entry, Address address, const char* what, const char* remedy) const {
  return {.place = program_.place_of(address),
          .function = program_.name_of(entry.address),
          .what = what,
          .remedy = remedy};
}

std::optional<std::uint32_t> Stack::measure(Entry entry, const State& start) {
  const Flow& flow = flows_.of(entry);
  const Reached reached = reach_.all(flow, start);
  std::uint32_t most = 0;
  bool is_known = true;
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    const Node& node = flow.nodes[i];
    const auto& before = reached.before[i];
    if (!before) continue;
    const Value pointer = before->registers[stack_pointer];
    const auto depth = static_cast<std::int32_t>(-pointer.offset);
    // The code that restores registers begins below where it ends.
    if (pointer.base != stack_pointer) {
      throw Unbounded(problem(entry, node.address, "the stack pointer is not known here",
                              "move it by constants only, and by the same on all paths"));
    }
    most = std::max({most, above_zero(depth), above_zero(stored_below(node.instruction, *before))});
    if (!node.calls && node.end != End::goes_on_elsewhere) continue;
    const auto called = callees(program_, flow, reached, i);
    if (called.empty()) {
      throw Unbounded(problem(entry, node.address, "the function called here is not known",
                              "call it by its name, or declare the table of its pointer "
                              "(units/call_table.hpp)"));
    }
    const unsigned link = node.calls ? node.instruction.destination : entry.link;
    for (const Address function : called) {
      if (!program_.is_code(function)) {
        if (node.calls) {
          throw Unbounded(problem(entry, node.address, "what is called here lies outside the code",
                                  "jump to it"));
        }
        // Another program takes over, with a stack of its own.
        continue;
      }
      const auto below = this->depth({.address = function, .link = link}, *before);
      is_known = is_known && below;
      most = std::max(most, above_zero(depth + static_cast<std::int32_t>(below.value_or(0))));
    }
  }
  if (!is_known) return std::nullopt;
  return most;
}

}  // namespace timing
