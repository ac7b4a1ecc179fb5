// SPDX-License-Identifier: Apache-2.0
// List, matrices, state machine and checksums in turn: work like that of common benchmarks of small
// processors, but written for this project.
#pragma once

#include <string_view>

#include "benchmark/linked_list.hpp"
#include "benchmark/matrix.hpp"
#include "benchmark/number_scanner.hpp"
#include "benchmark/processor.hpp"

namespace benchmark {

class CoreWork {
 public:
  void prepare(std::string_view text);
  ProcessorResult run(std::uint32_t iterations);

 private:
  std::uint16_t iterate(std::int16_t variation);

  LinkedList list_;
  MatrixWork matrix_;
  NumberScanner scanner_;
};

}  // namespace benchmark
