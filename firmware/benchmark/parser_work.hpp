// SPDX-License-Identifier: Apache-2.0
// The firmware's parser on lines of a sliced file.
#pragma once

#include <string_view>

#include "benchmark/processor.hpp"

namespace benchmark {

class ParserWork {
 public:
  void prepare(std::string_view text) { text_ = text; }
  // An iteration is the whole text; units are lines.
  ProcessorResult run(std::uint32_t iterations);

 private:
  std::string_view text_;
};

}  // namespace benchmark
