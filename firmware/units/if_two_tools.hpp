// SPDX-License-Identifier: Apache-2.0
// A value that only machines with two tools have: in an image for one it takes no room, where it is
// a member with [[no_unique_address]].
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "machine/tools.hpp"

namespace units {

// std::array<Value, 0> would take a byte.
template <class Value>
struct NoValue {
  // Only named in code that is left out.
  Value& operator[](std::size_t);
  const Value& operator[](std::size_t) const;
  void fill(const Value&) {}
};

template <class Value>
using IfTwoTools = std::conditional_t<most_tools == 1, NoValue<Value>, std::array<Value, 1>>;

}  // namespace units
