// SPDX-License-Identifier: Apache-2.0
// A program whose bound is the time that the processor model takes: every kind of instruction,
// loops that the code and a declaration bound, an event, calls of a known function and by a table.
#pragma once

#include <vector>

#include "tests/timing/short_program.hpp"
#include "tests/timing/trace.hpp"

namespace timing {

// Its instructions that tests refer to, by their numbers from the start.
namespace place {
inline constexpr std::size_t function = 2, counter = 3, counted_loop = 4, reads_product = 8,
                             bus_address = 27, call_by_table = 31, run_begins = 34,
                             declared_round = 35, limited_call = 36, behind_limited_call = 37,
                             back = 38, behind_loop = 39, run_ends = 40, known_call = 40,
                             event_behind_run = 41, limited_choice = 44, limited_event = 45,
                             counted_function = 47, shorter = 50, longer = 54, table = 56;
}

struct MeasuredProgram {
  Program program;
  std::vector<Step> steps;  // of the function, and the one behind it
  Clocks clocks{};  // of the function
  Clocks span{};  // of it up to the loop that a declaration bounds

  static Address address(std::size_t number);
};

MeasuredProgram measured_program();

}  // namespace timing
