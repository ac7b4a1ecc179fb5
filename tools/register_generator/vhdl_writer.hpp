// SPDX-License-Identifier: Apache-2.0
// What the writers of a peripheral's VHDL files share: lines of text, and the names of its types.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "register_generator/description.hpp"

namespace register_generator {

class VhdlWriter {
 protected:
  // `what` is in the file, which is made from the description `source`.
  VhdlWriter(const Peripheral& peripheral, std::string what, std::string source)
      : peripheral_(peripheral), what_(std::move(what)), source_(std::move(source)) {}

  // What every file begins with.
  void heading() {
    line("-- SPDX-License-Identifier: Apache-2.0");
    line("-- {} of `{}`. Generated from {}: do not edit.", what_, peripheral_.name, source_);
    line("");
    line("library ieee;");
    line("use ieee.std_logic_1164.all;");
    line("use ieee.numeric_std.all;");
    line("");
  }

  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }

  std::string record_of(const Register& r) const {
    return fmt::format("{}_{}_t", peripheral_.name, r.name);
  }
  std::string value_type(const Register& r) const {
    return r.is_array ? fmt::format("{}_{}_array_t", peripheral_.name, r.name) : record_of(r);
  }
  std::string event_type(const Register& r) const {
    return r.is_array ? fmt::format("std_ulogic_vector(0 to {})", r.count - 1) : "std_ulogic";
  }

  const Peripheral& peripheral_;
  std::string text_;

 private:
  std::string what_;
  std::string source_;
};

}  // namespace register_generator
