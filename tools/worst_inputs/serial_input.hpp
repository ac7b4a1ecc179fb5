// SPDX-License-Identifier: Apache-2.0
// What a host sends: bytes, and when.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace worst_inputs {

// Bytes without a pause between them, behind one.
struct Piece {
  std::uint32_t pause_us{};
  std::string bytes;
  bool waits = false;  // before the pause until all lines before are done, as a host does

  bool operator==(const Piece&) const = default;
};

using SerialInput = std::vector<Piece>;

std::size_t bytes_of(const SerialInput& input);
// Readable, on one line: "G1 X1\n <250 us> M105\n".
std::string text_of(const SerialInput& input);

}  // namespace worst_inputs
