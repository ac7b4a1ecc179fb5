// SPDX-License-Identifier: Apache-2.0
// The frame of the programs behind `bench processor`: prepare, measure between two marks, answer.
#pragma once

#include <string_view>

#include "benchmark/processor.hpp"

extern "C" {
extern benchmark::ProcessorOrder benchmark_order;
extern benchmark::ProcessorResult benchmark_result;
extern volatile std::uint32_t tohost;  // ends the program, by the convention of riscv-tests
// Empty: the simulation sees the processor come by, so that measuring costs no instruction.
void benchmark_begin();
void benchmark_end();
}

namespace benchmark {

// `Work` has prepare(text) and run(iterations), as those in this folder.
template <class Work>
[[noreturn]] void run_program(Work& work) {
  work.prepare({benchmark_order.text.data(), benchmark_order.text_bytes});
  benchmark_begin();
  benchmark_result = work.run(benchmark_order.iterations);
  benchmark_end();
  tohost = 1;
  for (;;) {
  }
}

}  // namespace benchmark
