// SPDX-License-Identifier: Apache-2.0
// The fast model refuses to write a waveform.
#include <stdexcept>

#include "sim/simulation/trace.hpp"

namespace sim {

void permit_tracing(VerilatedContext&) {}

std::unique_ptr<Trace> make_trace(Vprinter_core&, const std::string&) {
  throw std::runtime_error(
      "this program holds the fast model of the chip, which writes no waveforms");
}

}  // namespace sim
