// SPDX-License-Identifier: Apache-2.0
// The lines of a text, without their ends.
#pragma once

#include <optional>
#include <string_view>

namespace benchmark {

class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}

  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    std::size_t length = 0;
    while (length < rest_.size() && rest_[length] != '\n') ++length;
    const auto line = rest_.substr(0, length);
    rest_.remove_prefix(length < rest_.size() ? length + 1 : length);
    return line;
  }

 private:
  std::string_view rest_;
};

}  // namespace benchmark
