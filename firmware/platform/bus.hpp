// SPDX-License-Identifier: Apache-2.0
// The only interface to the hardware: words at addresses, and registers as typed values.
#pragma once

#include <cstddef>
#include <cstdint>

namespace platform {

// Defined once per program: volatile access on the chip, clocks of a Verilated peripheral in a
// host test.
std::uint32_t bus_read(std::uint32_t address);
void bus_write(std::uint32_t address, std::uint32_t value);

// `Register` is a struct of registers/; the forms with an index are for arrays of
// registers. A value of two words is read and written low word first.
template <class Register>
concept TwoWords = requires { typename Register::High; };

// Inlined, so that only the fields that are used are taken apart.
template <class Register>
[[gnu::always_inline]] inline Register read() {
  return Register::decode(bus_read(Register::address));
}

template <TwoWords Register>
[[gnu::always_inline]] inline Register read() {
  const auto low = read<typename Register::Low>();
  return Register::decode(low, read<typename Register::High>());
}

template <class Register>
[[gnu::always_inline]] inline Register read(std::size_t index) {
  return Register::decode(bus_read(Register::address_of(index)));
}

template <class Register>
[[gnu::always_inline]] inline void write(const Register& value) {
  if constexpr (TwoWords<Register>) {
    write(value.low());
    write(value.high());
  } else {
    bus_write(Register::address, value.encode());
  }
}

template <class Register>
[[gnu::always_inline]] inline void write(std::size_t index, const Register& value) {
  bus_write(Register::address_of(index), value.encode());
}

}  // namespace platform
