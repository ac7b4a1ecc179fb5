// SPDX-License-Identifier: Apache-2.0
// Replacement of the one place.
#include "tools/proof/mutation.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace proof {

std::string mutated(const std::string& text, const Mutation& mutation) {
  const std::size_t place = text.find(mutation.from);
  const auto fail = [&mutation](const char* what) {
    throw std::runtime_error(fmt::format("{}: mutation {} does not apply to {}: its text {}",
                                         mutation.list.string(), mutation.name,
                                         mutation.file.string(), what));
  };
  if (place == std::string::npos) fail("is not there");
  if (text.find(mutation.from, place + 1) != std::string::npos) fail("stands there more than once");
  if (mutation.from == mutation.to) fail("is not changed");
  std::string result = text;
  result.replace(place, mutation.from.size(), mutation.to);
  return result;
}

}  // namespace proof
