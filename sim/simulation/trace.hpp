// SPDX-License-Identifier: Apache-2.0
// Waveforms of the model: real in fst_trace.cpp, refused in no_trace.cpp, since tracing slows a
// model down.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

class VerilatedContext;
class Vprinter_core;

namespace sim {

class Trace {
 public:
  Trace() = default;
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;
  virtual ~Trace() = default;
  virtual void record(std::uint64_t half_clock) = 0;
};

// To be called before the model is traced for the first time.
void permit_tracing(VerilatedContext& context);
std::unique_ptr<Trace> make_trace(Vprinter_core& model, const std::string& file);

}  // namespace sim
