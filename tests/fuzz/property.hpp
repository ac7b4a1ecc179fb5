// SPDX-License-Identifier: Apache-2.0
// How a fuzz target reports a violated property: the message is printed, and the input is kept.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace fuzz {

template <class... Arguments>
[[noreturn]] void fail(fmt::format_string<Arguments...> sentence, Arguments&&... arguments) {
  fmt::print(stderr, "property violated: {}\n",
             fmt::format(sentence, std::forward<Arguments>(arguments)...));
  std::abort();
}

template <class... Arguments>
void require(bool holds, fmt::format_string<Arguments...> sentence, Arguments&&... arguments) {
  if (!holds) fail(sentence, std::forward<Arguments>(arguments)...);
}

}  // namespace fuzz
