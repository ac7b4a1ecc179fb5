// SPDX-License-Identifier: Apache-2.0
// What `bench processor` asks of a program, and its answer: words in memory, found by the symbols
// benchmark_order and benchmark_result.
#pragma once

#include <array>
#include <cstdint>

namespace benchmark {

struct ProcessorOrder {
  static constexpr std::size_t most_text_bytes = 12'288;

  std::uint32_t iterations{1};
  std::uint32_t text_bytes{};
  std::array<char, most_text_bytes> text{};  // lines of G-code, each with its line end
};

struct ProcessorResult {
  std::uint32_t units{};  // lines parsed, moves planned, otherwise iterations
  std::uint32_t checksum{};  // of all that was computed
};

static_assert(sizeof(ProcessorOrder) == 8 + ProcessorOrder::most_text_bytes);
static_assert(sizeof(ProcessorResult) == 8);

}  // namespace benchmark
