// SPDX-License-Identifier: Apache-2.0
// Functions inside a Verilated model: not part of Verilator's interface. Where their names are
// others, they are not linked, and eval() is called as usual.
#pragma once

namespace sim {

// For a model: `triggers` finds out which clocks have risen, `edges` is what eval() calls then,
// `settle` makes all that depends on registers fit them again. Null where there is none.
template <class Model>
struct ModelFunctions;

}  // namespace sim

// To be written after the header of the model.
#define STEPFABRIC_MODEL_FUNCTIONS(Name)                                            \
  [[gnu::weak]] void Name##___024root___eval_triggers__act(Name##___024root* root); \
  [[gnu::weak]] void Name##___024root___eval_nba(Name##___024root* root);           \
  [[gnu::weak]] void Name##___024root___eval_settle(Name##___024root* root);        \
  template <>                                                                       \
  struct sim::ModelFunctions<Name> {                                                \
    static constexpr auto triggers = &Name##___024root___eval_triggers__act;        \
    static constexpr auto edges = &Name##___024root___eval_nba;                     \
    static constexpr auto settle = &Name##___024root___eval_settle;                 \
  };
