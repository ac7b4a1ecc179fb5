// SPDX-License-Identifier: Apache-2.0
// Waveforms in the FST format, as GTKWave and Surfer read them.
#include <verilated_fst_c.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "sim/simulation/trace.hpp"
#include "Vprinter_core.h"

namespace sim {

namespace {

constexpr int all_levels = 99;

class FstTrace : public Trace {
 public:
  FstTrace(Vprinter_core& model, const std::string& file) {
    if (!std::ofstream(file)) throw std::runtime_error("cannot write " + file);
    model.trace(&writer_, all_levels);
    writer_.open(file.c_str());
  }
  ~FstTrace() override { writer_.close(); }
  void record(std::uint64_t half_clock) override { writer_.dump(half_clock); }

 private:
  VerilatedFstC writer_;
};

}  // namespace

void permit_tracing(VerilatedContext& context) { context.traceEverOn(true); }

std::unique_ptr<Trace> make_trace(Vprinter_core& model, const std::string& file) {
  return std::make_unique<FstTrace>(model, file);
}

}  // namespace sim
