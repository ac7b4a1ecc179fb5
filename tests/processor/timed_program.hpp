// SPDX-License-Identifier: Apache-2.0
// Programs without end of instructions of all rows of the table of times, in any order, with a
// handler: what interrupts are to be requested in at every phase.
#pragma once

#include <cstdint>
#include <vector>

namespace processor {

std::vector<std::uint8_t> timed_program(std::uint32_t seed);

}  // namespace processor
