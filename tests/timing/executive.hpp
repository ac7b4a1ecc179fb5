// SPDX-License-Identifier: Apache-2.0
// The main loop by its rule, run pass by pass with chosen times, and what its events come to.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "tools/timing/schedule.hpp"

namespace timing {

// Of a time, or a number, that is so much at most: what it is.
using Choice = std::function<Clocks(Clocks most)>;

struct Span {
  Clocks begin{}, end{};
};

// What happened, in clocks.
struct Run {
  std::array<std::vector<Span>, units::task_count> tasks;  // each time that it ran
  std::vector<Clocks> looks_pass;  // when the pass of each look at the serial line began
  bool motion_has_ended{};  // before a line that waited was there
  Clocks longest_pass{};
  std::size_t put_off{};  // how often a pass ended because a task had to wait

  // Of an event right after a task has begun, what needs so many of its next runs; 0 if the run is
  // too short.
  Clocks longest_response(units::Task task, std::size_t looks) const;
  // From the beginning of a pass that looks at the serial line to the end of the next round.
  Clocks longest_of_two_rounds() const;
};

class Executive {
 public:
  // Motion is under way, in hand is the reserve, and as many lines wait as there can be.
  Executive(const Facts& facts, const Load& load, Rate rate, Choice choice);

  // So many rounds, or as far as passes go on. It sleeps after each where motion lets it.
  Run rounds(std::size_t number, bool sleeps);
  // The heaters' watchdog, with as many lines as there can be whenever a heater is due.
  struct Feeds {
    Clocks longest{};  // from a first key to the next second one
    Clocks shortest{};  // from a first key to the next
  };
  Feeds feeds(std::size_t passes);

 private:
  struct Heat {
    bool is_timed{};
    bool was_due{};
    Clocks round_began_ms{}, fed_ms{};
    int turn{};
    std::vector<Clocks> first_keys, second_keys;
  };

  void pass();
  void work();
  bool may_begin(std::size_t task);
  bool is_due();
  void run(std::size_t task);
  void refill();
  void hand_over(Clocks took);
  void begin_motion();
  void sleep();
  Clocks known_in_hand(Clocks at) const;
  bool in_haste() const { return !resting_ && !collecting_; }
  void gap(units::Task before);
  Clocks bound(units::Task task) const { return *load_.tasks[static_cast<std::size_t>(task)]; }

  const Facts& facts_;
  const Load& load_;
  Rate rate_;
  Choice choice_;
  Clocks longest_, rounding_;
  Clocks time_{}, pass_began_{};
  Clocks ended_{};  // the task before; then it is read whether the next one may begin
  // Motion: the ends of the lines that are handed over, and what waits.
  std::deque<Clocks> queue_;
  Clocks motion_ends_{}, collected_{};
  std::uint64_t waiting_;
  std::uint64_t appended_{};  // in this round
  bool resting_{}, collecting_{}, full_{};
  Clocks full_until_{};
  // The round.
  std::size_t next_{};
  bool put_off_{};  // a task must wait
  bool goes_on_{};  // the next pass goes on with the round
  std::size_t rounds_{};
  Heat heat_;
  Run run_;
};

}  // namespace timing
