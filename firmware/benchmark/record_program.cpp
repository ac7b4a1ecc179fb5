// SPDX-License-Identifier: Apache-2.0
// The program of `bench processor` that runs the work of record_work.hpp.
#include "benchmark/processor_program.hpp"
#include "benchmark/record_work.hpp"

int main() {
  static benchmark::RecordWork work;
  benchmark::run_program(work);
}
