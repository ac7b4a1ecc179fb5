// SPDX-License-Identifier: Apache-2.0
// Which functions a call may reach.
#pragma once

#include <vector>

#include "tools/timing/reach.hpp"

namespace timing {

// Of a node that calls, or that goes on elsewhere: the constant that it jumps to, or all functions
// in the tables that its function declares (firmware/units/call_table.hpp). None where neither is
// known, or where a function has more such calls than it declares.
std::vector<Address> callees(const Program& program, const Flow& flow, const Reached& reached,
                             std::size_t node);

}  // namespace timing
