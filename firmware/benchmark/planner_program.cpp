// SPDX-License-Identifier: Apache-2.0
// The program of `bench processor` that runs the work of planner_work.hpp.
#include "benchmark/planner_work.hpp"
#include "benchmark/processor_program.hpp"
#include "machine/machine.hpp"
#include "motion/s_curve.hpp"

const bool motion::s_curve_in_image = machine::machine.limits.s_curve;

// It plans for a machine without.
const bool motion::backlash_in_image = false;

int main() {
  static benchmark::PlannerWork work;
  benchmark::run_program(work);
}
