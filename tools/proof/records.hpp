// SPDX-License-Identifier: Apache-2.0
// Proofs that held and mutations that were caught, recorded in the repository with a digest of
// everything that they depend on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace proof {

enum class Recorded { holds, caught };

struct Record {
  Recorded outcome{};
  std::string digest;

  bool operator==(const Record&) const = default;
};

// By the names of proofs and mutations.
using Records = std::map<std::string, Record>;

// Reads rows of name, outcome and digest, with tabulators between them; none where there is no such
// file. Throws std::runtime_error naming a row that is none.
Records read_records(const std::filesystem::path& file);

// Throws std::runtime_error where the file cannot be written.
void write_records(const std::filesystem::path& file, const Records& records);

// About `wanted` of the names, in any order: every name is in the part of one of as many seeds in
// a row as there are parts.
std::vector<std::string> part_of(std::vector<std::string> names, std::size_t wanted,
                                 std::uint64_t seed);

}  // namespace proof
