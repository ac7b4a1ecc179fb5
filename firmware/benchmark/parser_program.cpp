// SPDX-License-Identifier: Apache-2.0
// The program of `bench processor` that runs the work of parser_work.hpp.
#include "benchmark/parser_work.hpp"
#include "benchmark/processor_program.hpp"

int main() {
  static benchmark::ParserWork work;
  benchmark::run_program(work);
}
