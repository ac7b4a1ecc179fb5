// SPDX-License-Identifier: Apache-2.0
// A number without its sign.
#pragma once

#include <concepts>
#include <type_traits>

namespace units {

// Of the smallest number too, whose magnitude has no signed type.
template <std::signed_integral Number>
constexpr std::make_unsigned_t<Number> magnitude(Number value) {
  const auto bits = static_cast<std::make_unsigned_t<Number>>(value);
  return value < 0 ? std::make_unsigned_t<Number>{} - bits : bits;
}

}  // namespace units
