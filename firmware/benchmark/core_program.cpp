// SPDX-License-Identifier: Apache-2.0
// The program of `bench processor` that runs the work of core_work.hpp.
#include "benchmark/core_work.hpp"
#include "benchmark/processor_program.hpp"

int main() {
  static benchmark::CoreWork work;
  benchmark::run_program(work);
}
