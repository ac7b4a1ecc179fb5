// SPDX-License-Identifier: Apache-2.0
// A program that the build has assembled: its image and its symbols.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace processor {

struct Program {
  // From the first address of the memory on.
  std::vector<std::uint8_t> image;
  std::map<std::string, std::uint32_t> symbols;
};

// `name` without folder and ending.
Program read_program(const std::string& name);

}  // namespace processor
