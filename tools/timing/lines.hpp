// SPDX-License-Identifier: Apache-2.0
// Source lines by address, from the debug information of an image.
#pragma once

#include <elfutils/libdw.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace timing {

class Lines {
 public:
  // The file stays open.
  explicit Lines(int descriptor);
  ~Lines();
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  // "file:line"; empty where it is unknown.
  std::string at(std::uint32_t address) const;
  // Where instructions of this file begin, wherever the compiler has inlined them.
  std::vector<std::uint32_t> places_of(std::string_view file) const;

 private:
  Dwarf* dwarf_;
  int descriptor_;
};

}  // namespace timing
