// SPDX-License-Identifier: Apache-2.0
// How the types of a peripheral's registers are called in VHDL.
#pragma once

#include <fmt/format.h>

#include <string>

#include "register_generator/description.hpp"

namespace register_generator {

// Of one register, as in the calls to_NAME(word) and to_word(value) too.
inline std::string vhdl_register(const Peripheral& peripheral, const Register& r) {
  return fmt::format("{}_{}", peripheral.name, r.name);
}
inline std::string vhdl_record(const Peripheral& peripheral, const Register& r) {
  return vhdl_register(peripheral, r) + "_t";
}
// Of all elements of an array of registers; of the register where it is none.
inline std::string vhdl_type(const Peripheral& peripheral, const Register& r) {
  return r.is_array ? vhdl_register(peripheral, r) + "_array_t" : vhdl_record(peripheral, r);
}

}  // namespace register_generator
