// SPDX-License-Identifier: Apache-2.0
// What all programs of `bench processor` have in memory, and the marks around what is measured.
#include "benchmark/processor_program.hpp"

extern "C" {
[[gnu::used]] constinit benchmark::ProcessorOrder benchmark_order{};
[[gnu::used]] constinit benchmark::ProcessorResult benchmark_result{};
[[gnu::used]] constinit volatile std::uint32_t tohost = 0;

[[gnu::used, gnu::noinline]] void benchmark_begin() { asm volatile("" ::: "memory"); }
[[gnu::used, gnu::noinline]] void benchmark_end() { asm volatile("" ::: "memory"); }
}
