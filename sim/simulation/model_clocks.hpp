// SPDX-License-Identifier: Apache-2.0
// The clocks of the Verilated chip: evaluates the edges that change something, and no more.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <utility>

#include "sim/counting/chip_counts.hpp"
#include "sim/simulation/edges.hpp"
#include "sim/simulation/pins.hpp"
#include "Vprinter_controller.h"
#include "Vprinter_controller___024root.h"

// What Verilator's eval() calls once it knows which clocks have risen. Not part of its interface:
// where the names are others, they are not linked and eval() is called as usual.
[[gnu::weak]] void Vprinter_controller___024root___eval_triggers__act(
    Vprinter_controller___024root* root);
[[gnu::weak]] void Vprinter_controller___024root___eval_nba(Vprinter_controller___024root* root);
// Makes all that depends on registers fit them again.
[[gnu::weak]] void Vprinter_controller___024root___eval_settle(Vprinter_controller___024root* root);

namespace sim {

// Of all clocks, `clk` never rests; each other one has an output that says that its next edge
// changes nothing. After an input has changed all have an edge. While all of these rest, what
// counts on `clk` is carried over many clocks at once. `Model` is the chip; a template, so that
// what another version of Verilator keeps elsewhere is simply not used.
template <class Model>
class ModelClocks {
 public:
  ModelClocks(Model& model, Edges edges) : model_(model), edges_(edges) {
    model_.eval();  // Initial values.
    learn_triggers();
    leaps_ = direct_ && edges_ == Edges::leaping &&
             Vprinter_controller___024root___eval_settle != nullptr;
  }

  // No other clock than `clk` would have an edge now, unless an input changes.
  bool rests() const {
    return model_.processor_at_rest && model_.bus_at_rest && model_.axes_at_rest &&
           model_.peripherals_at_rest;
  }

  // Puts the model into the state in which its counters are these.
  void set_counts(const counting::Counts& counts) {
    if constexpr (counting::has_counts<Root>) {
      counting::write_counts(counts, *model_.rootp);
      Vprinter_controller___024root___eval_settle(model_.rootp);
    }
  }

  // Up to `most` clocks at once, if there is nothing to do in them but to count; none otherwise. To
  // be called without a new input. Returns their number.
  Clock leap(Clock most) {
    if constexpr (counting::has_counts<Root>) {
      if (leaps_ && most >= least_leap && rests() && counting::counts_are_usual(*model_.rootp)) {
        counting::Counts counts = counting::read_counts(*model_.rootp);
        const Clock clocks = counts.carry(most, least_leap);
        if (clocks != 0) {
          set_counts(counts);
        }
        return clocks;
      }
    }
    return 0;
  }

  // One clock. Says whether another clock than `clk` had an edge.
  bool clock(bool input_has_changed) {
    const bool all = input_has_changed || edges_ == Edges::all;
    const unsigned rising = always | (all || !model_.processor_at_rest ? processor : 0) |
                            (all || !model_.bus_at_rest ? bus : 0) |
                            (all || !model_.axes_at_rest ? axes : 0) |
                            (all || !model_.peripherals_at_rest ? peripherals : 0);
    if constexpr (has_triggers) {
      // Without a new input there is nothing to do between the edges, and which triggers fire is
      // known.
      if (direct_ && !all) {
        model_.rootp->__VnbaTriggered = triggers_[rising];
        Vprinter_controller___024root___eval_nba(model_.rootp);
        return rising != always;
      }
    }
    set_clocks(rising);
    model_.eval();
    fall();
    return rising != always;
  }

 private:
  using Root = std::remove_pointer_t<decltype(std::declval<Model&>().rootp)>;

  // Fewer clocks are sooner done one by one.
  static constexpr Clock least_leap = 12;

  // Bits of a set of clocks.
  static constexpr unsigned always = 1, processor = 2, bus = 4, axes = 8, peripherals = 16,
                            sets = 32;

  static constexpr bool has_levels = requires(Model& model) {
    model.rootp->__Vtrigprevexpr___TOP__clk__0;
    model.rootp->__Vtrigprevexpr___TOP__processor_clk__0;
    model.rootp->__Vtrigprevexpr___TOP__bus_clk__0;
    model.rootp->__Vtrigprevexpr___TOP__axes_clk__0;
    model.rootp->__Vtrigprevexpr___TOP__peripheral_clk__0;
  };
  static constexpr bool has_triggers = has_levels && requires(Model& model) {
    model.rootp->__VnbaTriggered = model.rootp->__VactTriggered;
    { model.rootp->__VactTriggered.any() } -> std::same_as<bool>;
  };

  void set_clocks(unsigned rising) {
    model_.clk = (rising & always) != 0;
    model_.processor_clk = (rising & processor) != 0;
    model_.bus_clk = (rising & bus) != 0;
    model_.axes_clk = (rising & axes) != 0;
    model_.peripheral_clk = (rising & peripherals) != 0;
  }

  // Nothing in the chip happens at a falling edge: where Verilator keeps the last level of a clock
  // in the open, it is given the falling edge.
  void fall() {
    set_clocks(0);
    if constexpr (has_levels) {
      model_.rootp->__Vtrigprevexpr___TOP__clk__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__processor_clk__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__bus_clk__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__axes_clk__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__peripheral_clk__0 = 0;
    } else {
      model_.eval();
    }
  }

  // Asks the model which triggers the edges of each set of clocks fire.
  void learn_triggers() {
    if constexpr (has_triggers) {
      if (Vprinter_controller___024root___eval_triggers__act == nullptr ||
          Vprinter_controller___024root___eval_nba == nullptr) {
        return;
      }
      direct_ = true;
      for (unsigned rising = 1; rising < sets; ++rising) {
        set_clocks(rising);
        Vprinter_controller___024root___eval_triggers__act(model_.rootp);
        triggers_[rising] = model_.rootp->__VactTriggered;
        direct_ = direct_ && triggers_[rising].any();
        fall();
      }
      model_.rootp->__VactTriggered = {};
    }
  }

  // An array where there are triggers.
  static auto no_triggers() {
    if constexpr (has_triggers) {
      return std::array<
          std::remove_cvref_t<decltype(std::declval<Model&>().rootp->__VnbaTriggered)>, sets>{};
    } else {
      return 0;
    }
  }

  Model& model_;
  Edges edges_;
  bool direct_ = false;
  bool leaps_ = false;
  decltype(no_triggers()) triggers_ = no_triggers();
};

}  // namespace sim
