// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/serial_input.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace worst_inputs {

std::size_t bytes_of(const SerialInput& input) {
  std::size_t bytes = 0;
  for (const Piece& piece : input) bytes += piece.bytes.size();
  return bytes;
}

std::string text_of(const SerialInput& input) {
  std::string text;
  for (const Piece& piece : input) {
    if (piece.waits) text += " <done> ";
    if (piece.pause_us != 0) text += fmt::format(" <{} us> ", piece.pause_us);
    for (const char byte : piece.bytes) {
      if (byte == '\n') {
        text += "\\n";
      } else if (byte >= ' ' && byte <= '~') {
        text += byte;
      } else {
        text += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
      }
    }
  }
  return text;
}

}  // namespace worst_inputs
