// SPDX-License-Identifier: Apache-2.0
// How often a random test is done, and from which seed: so many in CI, more by variables of the
// process's environment.
#pragma once

#include <cstdlib>

namespace host_test {

// Of the variable, which is a number above 0; elsewhere `usual`.
inline int number_of(const char* variable, int usual) {
  const char* text = std::getenv(variable);
  const int number = text == nullptr ? 0 : std::atoi(text);
  return number > 0 ? number : usual;
}

}  // namespace host_test
