// SPDX-License-Identifier: Apache-2.0
// Output to a terminal or pipe that may be closed: a job does not end because its output is
// not read.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace command {

// From now on a closed pipe, or a file as large as it may be (ulimit -f), is an error of the call
// that writes, and no signal.
void let_writes_fail();

// As fmt::print, which throws on a write error.
template <class... Values>
void say_to(std::FILE* stream, fmt::format_string<Values...> text, Values&&... values) {
  const std::string words = fmt::format(text, std::forward<Values>(values)...);
  std::fwrite(words.data(), 1, words.size(), stream);
}
template <class... Values>
void say(fmt::format_string<Values...> text, Values&&... values) {
  say_to(stdout, text, std::forward<Values>(values)...);
}

}  // namespace command
