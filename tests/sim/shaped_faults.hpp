// SPDX-License-Identifier: Apache-2.0
// What a faulty printer makes of a file, and whether it is beyond what shaping explains.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "shaped_printer.hpp"

namespace tests {

enum class Fault {
  left_out,
  swapped,
  end_off_by_one,
  axis_off,
  too_much_filament,
  late_z,
  forth_and_back,
  moved_after_end,
  slow_shaper,
  long_advance,
  too_fast,
  count
};
std::string name_of(Fault fault);

// The same lines, with other ways; empty where they have no place for the fault.
std::vector<Command> faulty(Fault fault, const std::vector<Command>& commands,
                            const PlanLimits& limits, std::mt19937& random);

// How far each axis may be from where it is without a shaper, at any time.
Axes tolerance_of(const std::vector<Command>& commands, const ShapingChoice& shaping,
                  double slot_s);
// Whether the ends of the lines were passed in their order, as near as this, and rests kept to the
// step. A judge that says good to what is not passed here is wrong.
bool passes(const std::vector<Command>& commands, const ShapedPrinter& printer,
            const Axes& tolerance);

// What the judge says; empty where all is good.
std::string complaint_of(const ShapedPrinter& printer, const std::vector<Command>& commands);

}  // namespace tests
