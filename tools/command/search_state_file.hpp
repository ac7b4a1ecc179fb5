// SPDX-License-Identifier: Apache-2.0
// The state of a search for bad inputs in a file, with what it is a search of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sim/simulation/elf_image.hpp"
#include "tools/worst_inputs/search.hpp"

namespace command {

class SearchStateFile {
 public:
  // Without a name nothing is kept.
  SearchStateFile(std::filesystem::path file, const sim::ElfImage& firmware, std::uint64_t seed);

  bool is_there() const;
  // Throws std::runtime_error where the state is that of another firmware, program or seed.
  void resume(worst_inputs::Search& search) const;
  void write(const worst_inputs::Search& search) const;

 private:
  std::filesystem::path file_;
  std::vector<std::uint8_t> of_;
};

}  // namespace command
