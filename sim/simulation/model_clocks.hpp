// SPDX-License-Identifier: Apache-2.0
// The clocks of the Verilated chip: evaluates only edges that change something.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <utility>

#include "sim/counting/chip_counts.hpp"
#include "sim/simulation/activity.hpp"
#include "sim/simulation/edges.hpp"
#include "sim/simulation/evaluation_counts.hpp"
#include "sim/simulation/model_functions.hpp"
#include "sim/simulation/pins.hpp"

namespace sim {

// Of all clocks, the free-running one never rests; each other one has an output that says that its
// next edge changes nothing. After an input has changed all have an edge. While all of these rest,
// what counts on the free-running one is carried over many clocks at once. `Model` is the chip; a
// template, so that what another version of Verilator keeps elsewhere is simply not used.
template <class Model>
class ModelClocks {
 public:
  ModelClocks(Model& model, Edges edges) : model_(model), edges_(edges) {
    model_.eval();  // Initial values.
    learn_triggers();
    leaps_ = direct_ && edges_ == Edges::leaping && Functions::settle != nullptr;
  }

  // Clocks are counted there from now on.
  void count_into(EvaluationCounts& counts) { evaluations_ = &counts; }

  // No other clock than the free-running one would have an edge now, unless an input changes.
  bool rests() const {
    return model_.at_rest_processor && model_.at_rest_registers && model_.at_rest_axes &&
           model_.at_rest_peripherals;
  }

  // Puts the model into the state in which its counters are these.
  void set_counts(const counting::Counts& counts) {
    if constexpr (counting::has_counts<Root>) {
      counting::write_counts(counts, *model_.rootp);
      Functions::settle(model_.rootp);
    }
  }

  // Up to `most` clocks at once, if there is nothing to do in them but to count; none otherwise. To
  // be called without a new input. Returns their number. `limited_by`: what sets `most`.
  Clock leap(Clock most, LeapEnd limited_by = LeapEnd::device) {
    if constexpr (counting::has_counts<Root>) {
      if (leaps_ && most >= least_leap && rests() && counting::counts_are_usual(*model_.rootp)) {
        const ActivityScope scope(Activity::leaps);
        counting::Counts counts = counting::read_counts(*model_.rootp);
        const Clock clocks = counts.carry(most, least_leap);
        if (clocks == 0) return 0;
        if (evaluations_ != nullptr) {
          count_leap(clocks, clocks == most ? limited_by
                                            : counting::read_counts(*model_.rootp).end_of(clocks));
        }
        set_counts(counts);
        return clocks;
      }
    }
    return 0;
  }

  // An edge of the processor's clock alone, which the chip never has: to bring it to rest in a
  // state that was put into it.
  void clock_processor() {
    set_clocks(processor);
    model_.eval();
    fall();
  }

  // One clock. Says whether another clock than the free-running one had an edge. `for_processor`:
  // the processor's clock has one in any case, for an input that only this clock takes over.
  bool clock(bool input_has_changed, bool for_processor = false) {
    const ActivityScope scope(Activity::netlist);
    const bool all = input_has_changed || edges_ == Edges::all;
    const unsigned rising = free_running |
                            (all || for_processor || !model_.at_rest_processor ? processor : 0) |
                            (all || !model_.at_rest_registers ? registers : 0) |
                            (all || !model_.at_rest_axes ? axes : 0) |
                            (all || !model_.at_rest_peripherals ? peripherals : 0);
    if (evaluations_ != nullptr) count_clock(input_has_changed, rising);
    if constexpr (has_triggers) {
      // Without a new input there is nothing to do between the edges, and which triggers fire
      // is known.
      if (direct_ && !all) {
        model_.rootp->__VnbaTriggered = triggers_[rising];
        Functions::edges(model_.rootp);
        return rising != free_running;
      }
    }
    set_clocks(rising);
    model_.eval();
    fall();
    return rising != free_running;
  }

 private:
  using Functions = ModelFunctions<Model>;
  using Root = std::remove_pointer_t<decltype(std::declval<Model&>().rootp)>;

  // Fewer clocks are faster one by one.
  static constexpr Clock least_leap = 12;

  // Bits of a set of clocks.
  static constexpr unsigned free_running = 1, processor = 2, registers = 4, axes = 8,
                            peripherals = 16, sets = 32;

  static constexpr bool has_levels = requires(Model& model) {
    model.rootp->__Vtrigprevexpr___TOP__clocks_free_running__0;
    model.rootp->__Vtrigprevexpr___TOP__clocks_processor__0;
    model.rootp->__Vtrigprevexpr___TOP__clocks_registers__0;
    model.rootp->__Vtrigprevexpr___TOP__clocks_axes__0;
    model.rootp->__Vtrigprevexpr___TOP__clocks_peripherals__0;
  };
  static constexpr bool has_triggers = has_levels && requires(Model& model) {
    model.rootp->__VnbaTriggered = model.rootp->__VactTriggered;
    { model.rootp->__VactTriggered.any() } -> std::same_as<bool>;
  };

  void count_leap(Clock clocks, LeapEnd end) {
    ++evaluations_->leaps;
    evaluations_->leapt_clocks += clocks;
    ++evaluations_->leaps_ended_by[static_cast<std::size_t>(end)];
  }

  void count_clock(bool input_has_changed, unsigned rising) {
    ++evaluations_->evaluated_clocks;
    if (input_has_changed) {
      ++evaluations_->after_input;
      return;
    }
    evaluations_->processor += (rising & processor) != 0;
    evaluations_->registers += (rising & registers) != 0;
    evaluations_->axes += (rising & axes) != 0;
    evaluations_->peripherals += (rising & peripherals) != 0;
    evaluations_->free_running_alone += rising == free_running;
  }

  void set_clocks(unsigned rising) {
    model_.clocks_free_running = (rising & free_running) != 0;
    model_.clocks_processor = (rising & processor) != 0;
    model_.clocks_registers = (rising & registers) != 0;
    model_.clocks_axes = (rising & axes) != 0;
    model_.clocks_peripherals = (rising & peripherals) != 0;
  }

  // Nothing in the chip happens at a falling edge: where Verilator keeps the last level of a clock
  // in the open, it is given the falling edge.
  void fall() {
    set_clocks(0);
    if constexpr (has_levels) {
      model_.rootp->__Vtrigprevexpr___TOP__clocks_free_running__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__clocks_processor__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__clocks_registers__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__clocks_axes__0 = 0;
      model_.rootp->__Vtrigprevexpr___TOP__clocks_peripherals__0 = 0;
    } else {
      model_.eval();
    }
  }

  // Asks the model which triggers the edges of each set of clocks fire.
  void learn_triggers() {
    if constexpr (has_triggers) {
      if (Functions::triggers == nullptr || Functions::edges == nullptr) return;
      direct_ = true;
      for (unsigned rising = 1; rising < sets; ++rising) {
        set_clocks(rising);
        Functions::triggers(model_.rootp);
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
  EvaluationCounts* evaluations_ = nullptr;
  decltype(no_triggers()) triggers_ = no_triggers();
};

}  // namespace sim
