// SPDX-License-Identifier: Apache-2.0
// Clocks carried over at once leave what as many edges leave: two models of the chip, asleep, are
// put into the same random states of all that counts, near every event and far from it.
#include <gtest/gtest.h>

#include <random>

#include "sim/counting/chip_counts.hpp"
#include "sim/simulation/model_clocks.hpp"
#include "Vchip_without_processor.h"
#include "Vchip_without_processor___024root.h"
#include "Vprinter_core.h"
#include "Vprinter_core___024root.h"

STEPFABRIC_MODEL_FUNCTIONS(Vprinter_core)
STEPFABRIC_MODEL_FUNCTIONS(Vchip_without_processor)

void vl_stop(const char* file, int line, const char*) {
  ADD_FAILURE() << "an assertion of the hardware failed: " << file << ":" << line;
}
void vl_fatal(const char* file, int line, const char*, const char* message) {
  ADD_FAILURE() << message << ": " << file << ":" << line;
}

namespace {

using counting::Counts;

static_assert(counting::has_counts<Vprinter_core___024root>);
static_assert(counting::has_counts<Vchip_without_processor___024root>);
static_assert(counting::has_processor<Vprinter_core___024root>);

// A chip whose processor sleeps forever, or is not there.
template <class Model>
class Sleeper {
 public:
  explicit Sleeper(sim::Edges edges) : model_(&context_), clocks_(model_, edges) {
    model_.clock_frequency_hz = 4'000'000;
    model_.receive = 1;
    model_.tms = 1;
    constexpr std::uint32_t wait_for_interrupt = 0x10500073, jump_back = 0xffdff06f;
    if constexpr (counting::has_processor<std::remove_pointer_t<decltype(model_.rootp)>>) {
      write(model_, 0, wait_for_interrupt);
      write(model_, 1, jump_back);
    }
    restart();
  }

  // From reset until everything rests.
  void restart() {
    model_.reset = 1;
    for (int i = 0; i < 8; ++i) clocks_.clock(true);
    model_.reset = 0;
    clocks_.clock(true);
    for (int i = 0; i < 100; ++i) clocks_.clock(false);
    // Motion without a line has one without steps.
    auto& root = *model_.rootp;
    root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__executed_ticks_q = 1000;
  }

  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;
  // A model is removed from the context of the thread, which of several models may be another's.
  ~Sleeper() { Verilated::threadContextp(&context_); }

  void put(const Counts& counts) { clocks_.set_counts(counts); }
  Counts counts() const { return counting::read_counts(*model_.rootp); }
  bool rests() const { return clocks_.rests(); }

  void run(sim::Clock clocks) {
    for (sim::Clock done = 0; done < clocks;) {
      const sim::Clock leap = clocks_.leap(clocks - done);
      if (leap == 0) clocks_.clock(false);
      leapt_ += leap;
      done += leap == 0 ? 1 : leap;
    }
  }
  sim::Clock leapt() const { return leapt_; }

  // Every pin, and whether each block is at rest.
  auto pins() const {
    return std::tuple(model_.step, model_.direction, model_.motor_enable, model_.transmit,
                      model_.fan_gate, model_.heater_gate, model_.heater_supply, model_.fault,
                      model_.sensor_drive_enable, model_.sensor_drive_level, model_.sleeping,
                      model_.at_rest_processor, model_.at_rest_registers, model_.at_rest_axes,
                      model_.at_rest_peripherals);
  }

 private:
  template <class Whole>
  static void write(Whole& model, std::uint32_t word, std::uint32_t value) {
#define LANE(n)                                                                                 \
  model.rootp                                                                                   \
      ->printer_core__DOT__with_processor_computing__DOT__ram__DOT__banks_n1_lanes_n##n##_bytes \
          [word]
    LANE(1) = static_cast<std::uint8_t>(value);
    LANE(2) = static_cast<std::uint8_t>(value >> 8);
    LANE(3) = static_cast<std::uint8_t>(value >> 16);
    LANE(4) = static_cast<std::uint8_t>(value >> 24);
#undef LANE
  }

  VerilatedContext context_;
  Model model_;
  sim::ModelClocks<Model> clocks_;
  sim::Clock leapt_ = 0;
};

class RandomCounts {
 public:
  explicit RandomCounts(std::uint64_t seed) : random_(seed) {}

  std::uint64_t below(std::uint64_t limit) { return random_() % limit; }
  bool one_in(std::uint64_t times) { return below(times) == 0; }
  // Of any magnitude up to 2^bits.
  std::uint64_t magnitude(unsigned bits) { return random_() >> (64 - bits) >> below(bits); }
  std::int64_t either_sign(std::uint64_t value) {
    return static_cast<std::int64_t>(one_in(2) ? value : 0 - value);
  }

  Counts around(Counts counts) {
    counts.timer.now = random_() >> below(60);
    counts.timer.deadline = counts.timer.now + (one_in(4) ? 0 : 1) + magnitude(20);
    counts.timer.reached = one_in(8);
    counts.motion_time = one_in(4) ? ~below(1000) : random_();
    counts.processor_cycles = one_in(4) ? ~below(1000) : random_();
    counts.processor_cycles_stopped = one_in(4);
    counts.converter_tick.phase = static_cast<std::uint32_t>(below(1024));
    counts.heater_tick.phase = static_cast<std::uint32_t>(below(1024));
    counts.heater_slot.phase =
        static_cast<std::uint32_t>(one_in(8) ? magnitude(24) : below(counts.heater_slot.last + 1));
    counts.converter_cycles.now =
        (counts.converter_wakes[below(2)] - static_cast<std::uint32_t>(magnitude(24))) &
        counting::Cycles::mask;
    counts.motion_watchdog = watchdog();
    counts.time_base = base(counts.time_base.advance);
    counts.motion_watchdog.moving = counts.time_base.active;
    counts.fan = fan();
    return counts;
  }

 private:
  counting::MotionWatchdog watchdog() {
    counting::MotionWatchdog watchdog;
    watchdog.limit = one_in(4) ? 0 : static_cast<std::uint32_t>(magnitude(32));
    watchdog.left = static_cast<std::uint32_t>(one_in(2) ? watchdog.limit : magnitude(12));
    if (watchdog.limit == 0 && !one_in(4)) watchdog.left = ~std::uint32_t{0};
    return watchdog;
  }

  // Whether time passes is the feed override's, which would correct it with its next edge.
  counting::TimeBase base(bool advance) {
    counting::TimeBase base;
    base.active = !one_in(4);
    base.advance = advance;
    base.phase = one_in(4) ? ~magnitude(60) : random_();
    base.rate_floor = static_cast<std::uint32_t>(magnitude(one_in(4) ? 31 : 20));
    base.rate = one_in(16) ? std::uint64_t{1} << 63 : magnitude(one_in(4) ? 63 : 52);
    base.acceleration = one_in(3) ? 0 : either_sign(magnitude(one_in(4) ? 63 : 50));
    base.jerk = one_in(2) ? 0 : either_sign(magnitude(one_in(4) ? 63 : 40));
    base.accelerating = one_in(2);
    base.decelerating = one_in(2);
    return base;
  }

  counting::Fan fan() {
    counting::Fan fan;
    fan.slot_cycles = static_cast<std::uint32_t>(one_in(8) ? 0 : magnitude(10));
    fan.duty = static_cast<std::uint32_t>(one_in(4) ? 0 : one_in(4) ? 255 : below(256));
    fan.remaining_cycles = static_cast<std::uint32_t>(one_in(4) ? 0 : magnitude(10));
    fan.slot = static_cast<std::uint8_t>(below(255));
    fan.slots_on = static_cast<std::uint8_t>(one_in(4) ? 0 : below(256));
    fan.level = one_in(2);
    return fan;
  }

  std::mt19937_64 random_;
};

template <class Model>
class Leap : public testing::Test {};

using Models = testing::Types<Vprinter_core, Vchip_without_processor>;
TYPED_TEST_SUITE(Leap, Models);

TYPED_TEST(Leap, leaves_what_as_many_edges_of_the_clock_leave) {
  Sleeper<TypeParam> edges(sim::Edges::all), leaps(sim::Edges::leaping);
  RandomCounts random(12);
  sim::Clock clocks = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    edges.restart();
    leaps.restart();
    ASSERT_TRUE(edges.rests() && leaps.rests());
    const Counts counts = random.around(edges.counts());
    edges.put(counts);
    leaps.put(counts);
    // In some pieces, so that what lies between two events is compared too.
    for (int piece = 0; piece < 4; ++piece) {
      const sim::Clock length = 1 + random.magnitude(11);
      edges.run(length);
      leaps.run(length);
      clocks += length;
      ASSERT_EQ(edges.counts(), leaps.counts()) << "trial " << trial << ", piece " << piece;
      ASSERT_EQ(edges.pins(), leaps.pins()) << "trial " << trial << ", piece " << piece;
    }
  }
  EXPECT_EQ(edges.leapt(), 0u);
  // Otherwise nothing was compared.
  EXPECT_GT(leaps.leapt(), clocks / 3);
}

}  // namespace
