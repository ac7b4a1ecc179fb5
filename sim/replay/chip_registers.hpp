// SPDX-License-Identifier: Apache-2.0
// The registers and memories that the netlist of the whole chip and the one without a processor
// both have, in one order.
#pragma once

#include <verilated.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace replay {

// Of a model: where it lies, and how large it is; of a memory also each of its elements.
struct Register {
  const char* name;
  std::uint8_t* place;
  std::size_t bytes;
  std::size_t element_bytes;

  std::span<std::uint8_t> contents() const { return {place, bytes}; }
};

template <class Value>
inline constexpr std::size_t element_size = sizeof(Value);
template <class Element, std::size_t count>
inline constexpr std::size_t element_size<VlUnpacked<Element, count>> = sizeof(Element);

template <class Value>
Register described(const char* name, Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  return {name, reinterpret_cast<std::uint8_t*>(&value), sizeof value, element_size<Value>};
}

// `Root` is the structure of the model's variables; the names are those of the whole chip.
template <class Root>
std::vector<Register> registers_of_whole_chip(Root& root) {
#define REGISTER(in_whole, in_rest) described(#in_whole, root.in_whole),
  return {
#include "chip_registers.inc"
  };
#undef REGISTER
}

template <class Root>
std::vector<Register> registers_without_processor([[maybe_unused]] Root& root) {
#define REGISTER(in_whole, in_rest) described(#in_whole, root.in_rest),
  return {
#include "chip_registers.inc"
  };
#undef REGISTER
}

}  // namespace replay
