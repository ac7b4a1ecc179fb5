// SPDX-License-Identifier: Apache-2.0
// Instructions from a function's start on.
#include "tools/timing/flow.hpp"

#include <algorithm>
#include <optional>

#include "tools/timing/costs.hpp"
#include "tools/timing/problem.hpp"
#include "tools/timing/state.hpp"

namespace timing {

namespace {

using processor::Instruction;
using processor::Operation;

bool is_link(unsigned index) { return index == return_register || index == second_link; }

bool is_trap(Operation operation) {
  return operation == Operation::illegal || operation == Operation::environment_call ||
         operation == Operation::breakpoint || operation == Operation::fetch_fault;
}

constexpr std::uint32_t status_register = 0x300, interrupt_enable = 8;

// May set mstatus.MIE.
bool enables_interrupts(const Instruction& instruction) {
  if (instruction.operation == Operation::trap_return) return true;
  if (instruction.operation != Operation::csr || instruction.immediate != status_register) {
    return false;
  }
  const std::uint32_t kind = instruction.word >> 12 & 7, value = instruction.word >> 15 & 31;
  constexpr std::uint32_t write = 1, set = 2, write_immediate = 5, set_immediate = 6;
  if (kind == write || kind == set) return value != 0;
  return (kind == write_immediate || kind == set_immediate) && (value & interrupt_enable) != 0;
}

}  // namespace

std::optional<Address> place_that_enables_interrupts(const Program& program, bool has_zbb) {
  const Flows flows(program, has_zbb);
  for (Address address = program.first; address < program.code_end;) {
    const Instruction instruction = flows.at(address);
    if (enables_interrupts(instruction)) return address;
    address += instruction.bytes;
  }
  return std::nullopt;
}

void refuse_interrupts(const Program& program, bool has_zbb) {
  if (const auto place = place_that_enables_interrupts(program, has_zbb)) {
    throw std::runtime_error(program.place_of(*place) + ": in " + program.name_of(*place) +
                             ": interrupts are enabled, whose time no bound contains: leave them "
                             "disabled, and look at them in the main loop");
  }
}

Instruction Flows::at(Address address) const {
  return processor::decode(program_.word_at(address), address, has_zbb_);
}

// A jump there is a call in place of a return.
bool Flows::is_other_function(Address target, Entry entry) const {
  const auto symbol = program_.symbols.find(target);
  return target != entry.address && symbol != program_.symbols.end();
}

const Flow& Flows::of(Entry entry) {
  const auto known = flows_.find(entry);
  if (known != flows_.end()) return known->second;
  if (!under_way_.insert(entry).second) {
    throw Unbounded({.place = program_.place_of(entry.address),
                     .function = program_.name_of(entry.address),
                     .what = "the function calls itself, or others that call it",
                     .remedy = "write it as a loop"});
  }
  try {
    Flow flow = explore(entry);
    under_way_.erase(entry);
    return flows_.emplace(entry, std::move(flow)).first->second;
  } catch (...) {
    under_way_.erase(entry);
    throw;
  }
}

bool Flows::returns(Entry entry) {
  std::set<Address> asked;
  return returns(entry, asked);
}

bool Flows::returns(Entry entry, std::set<Address>& asked) {
  // Functions that only go on in each other do not return; `bound` refuses them.
  if (!asked.insert(entry.address).second) return false;
  return std::ranges::any_of(of(entry).nodes, [&](const Node& node) {
    if (node.end == End::returns) return true;
    if (node.end != End::goes_on_elsewhere) return false;
    // Where an indirect jump goes is not known yet.
    return node.instruction.operation != Operation::jump ||
           returns({.address = node.instruction.immediate, .link = entry.link}, asked);
  });
}

Flow Flows::explore(Entry entry) {
  Flow flow;
  std::map<Address, std::size_t> places;
  std::vector<Address> open{entry.address};
  const auto node_at = [&](Address address) {
    const auto [place, is_new] = places.emplace(address, flow.nodes.size());
    if (is_new) {
      flow.nodes.push_back({.address = address, .instruction = at(address), .ways = {}});
      open.push_back(address);
    }
    return place->second;
  };
  open.clear();
  node_at(entry.address);
  while (!open.empty()) {
    const Address address = open.back();
    open.pop_back();
    if (!program_.is_code(address)) {
      throw Unbounded({.place = program_.place_of(entry.address),
                       .function = program_.name_of(entry.address),
                       .what = "a path leaves the code",
                       .remedy = "mark the function called last as [[noreturn]]"});
    }
    Node node = flow.nodes[places.at(address)];
    const Instruction& instruction = node.instruction;
    const Address next = address + instruction.bytes;
    const unsigned written = instruction.destination;
    if (is_branch(instruction.operation)) {
      node.ways = {{.to = node_at(next)}, {.to = node_at(instruction.immediate), .taken = true}};
    } else if (instruction.operation == Operation::jump && !is_link(written)) {
      if (is_other_function(instruction.immediate, entry)) {
        node.end = End::goes_on_elsewhere;
      } else {
        node.ways = {{.to = node_at(instruction.immediate)}};
      }
    } else if (instruction.operation == Operation::jump) {
      node.calls = true;
      if (returns({.address = instruction.immediate, .link = written})) {
        node.ways = {{.to = node_at(next)}};
      } else {
        node.end = End::halts;
      }
    } else if (instruction.operation == Operation::jump_register && is_link(written)) {
      node.calls = true;
      node.ways = {{.to = node_at(next)}};
    } else if (instruction.operation == Operation::jump_register) {
      node.end = instruction.first == entry.link && instruction.immediate == 0
                     ? End::returns
                     : End::goes_on_elsewhere;
    } else if (instruction.operation == Operation::trap_return) {
      node.end = End::returns;
    } else if (is_trap(instruction.operation)) {
      node.end = End::halts;
    } else {
      node.ways = {{.to = node_at(next)}};
    }
    flow.nodes[places.at(address)] = std::move(node);
  }
  return flow;
}

}  // namespace timing
