// SPDX-License-Identifier: Apache-2.0
// Symbols of parts, and where their pins end.
#pragma once

#include <vector>

#include "tools/wiring/drawing.hpp"

namespace wiring {

struct Terminal {
  Place at;
  Place outward;  // a unit away from the symbol
};

// Of the part's pins, in the order of its kind.
std::vector<Terminal> terminals_of(const Description& description, const Part& part);

// `value` stands next to the symbol, under its designator.
void draw_symbol(Drawing& drawing, const Description& description, const Part& part,
                 const std::string& value);

}  // namespace wiring
