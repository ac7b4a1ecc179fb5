// SPDX-License-Identifier: Apache-2.0
// Files that exist are compared by identity, others by path.
#include "tools/command/file_roles.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace command {

namespace {

namespace fs = std::filesystem;

bool are_one(const fs::path& left, const fs::path& right) {
  std::error_code ignored;
  const fs::file_type type = fs::status(left, ignored).type();
  if (type == fs::file_type::regular) return fs::equivalent(left, right, ignored);
  if (type != fs::file_type::not_found) return false;
  return fs::weakly_canonical(left, ignored) == fs::weakly_canonical(right, ignored);
}

}  // namespace

void check_that_files_differ(std::span<const NamedFile> read, std::span<const NamedFile> written) {
  for (const NamedFile& output : written) {
    if (output.path.empty()) continue;
    for (const NamedFile& input : read) {
      if (input.path.empty() || !are_one(output.path, input.path)) continue;
      throw std::runtime_error(fmt::format("{} {} would overwrite {} {}: choose another path",
                                           output.name, output.path.string(), input.name,
                                           input.path.string()));
    }
    for (const NamedFile& other : written) {
      if (&other == &output) break;
      if (other.path.empty() || !are_one(output.path, other.path)) continue;
      throw std::runtime_error(fmt::format("{} and {} would both write {}: choose another path",
                                           other.name, output.name, output.path.string()));
    }
  }
}

}  // namespace command
