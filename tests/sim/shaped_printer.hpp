// SPDX-License-Identifier: Apache-2.0
// A printer with input shaping and linear advance by direct convolution; the judge sees its steps.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "shaped_plan.hpp"
#include "sim/report/point_check.hpp"

namespace tests {

struct ShaperChoice {
  std::string kind = "none";  // as M593 P names it
  double hertz{};
  double damping = 0.1;
};
struct ShapingChoice {
  ShaperChoice x, y;
  double advance_s{};

  bool any() const { return x.kind != "none" || y.kind != "none" || advance_s > 0; }
};

// Of weights that sum up to 1, from the first on.
struct TimedImpulse {
  double weight{}, seconds{};
};
std::vector<TimedImpulse> impulses_of(const ShaperChoice& shaper);
double mean_of(const std::vector<TimedImpulse>& impulses);
report::ShapingSetting setting_of(const ShapingChoice& choice);

// A line of the file and what the printer makes of it.
struct Command {
  std::string text;
  std::vector<Way> ways{};
  double pause_s = -1;  // G4
  bool waits{};  // for the end of all motion
  std::optional<ShapingChoice> shaping{};  // from then on
  bool is_move{};  // has an end that is judged
};

// Steps out of nowhere, forth and back, after a part of the motion from rest to rest.
struct Twitch {
  std::size_t axis{};
  std::int64_t steps{};  // of the way out
  std::size_t run{};  // from rest to rest
  double part{};  // of its edges; 1: after the last one
  bool once{};  // does not come back
};

class ShapedPrinter {
 public:
  ShapedPrinter(double clock_hz, const ShapingChoice& shaping, const PlanLimits& limits = {},
                std::size_t buffered_lines = 8);

  // What its motors make instead of what the file says.
  void be_shaped_by(const ShapingChoice& shaping) { real_ = shaping; }
  void run(const std::vector<Command>& commands);
  void twitch(const Twitch& twitch) { twitch_ = twitch; }

  const report::PointCheck& check() const { return check_; }
  // All edges so far, for oracles.
  struct Edge {
    std::uint64_t clock{};
    std::size_t axis{};
    int direction{};
  };
  const std::vector<Edge>& edges() const { return edges_; }
  // Where it stood when each motion had ended, and after which command.
  struct Rest {
    report::Steps position{};
    std::size_t command{}, edges{};
  };
  const std::vector<Rest>& rests() const { return rests_; }
  double slot_s() const;
  static constexpr report::Steps start{1234, 567, 0, 0};

 private:
  void run_to_rest(const std::vector<Command>& commands, std::size_t first, std::size_t last);
  std::vector<Edge> shaped_edges(const Plan& plan) const;
  std::vector<Edge> plain_edges(const Plan& plan) const;
  void add_steps(std::vector<Edge>& edges, std::size_t axis, double begin,
                 std::int64_t steps) const;
  void insert_twitch(std::vector<Edge>& edges);
  void play(const Edge& edge);
  void send(const std::string& text);
  const ShapingChoice& real() const { return real_ ? *real_ : shaping_; }

  double clock_hz_;
  ShapingChoice shaping_, given_;
  std::optional<ShapingChoice> real_;
  PlanLimits limits_;
  std::size_t buffered_;
  std::optional<Twitch> twitch_;
  std::size_t runs_ = 0;
  double slot_s_{};  // of the present motion
  std::uint64_t clock_ = 0;  // now
  std::size_t file_line_ = 0;
  report::Steps position_ = start;
  std::vector<Edge> edges_;
  std::vector<Rest> rests_;
  report::PointCheck check_;
};

}  // namespace tests
