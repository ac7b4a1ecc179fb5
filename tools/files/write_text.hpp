// SPDX-License-Identifier: Apache-2.0
// Writing a text to a file.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace files {

// As it is, in the place of what the file held. Throws std::runtime_error where not all is written.
inline void write_text(const std::filesystem::path& file, std::string_view text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace files
