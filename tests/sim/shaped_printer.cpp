// SPDX-License-Identifier: Apache-2.0
// Impulses as published, their sum at the end of each slot, and steps spread over the slot.
#include "shaped_printer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tests {

namespace {

constexpr double advance_window_s = 0.020;

report::MachineFacts facts_of(const ShapingChoice& shaping, const PlanLimits& limits) {
  report::MachineFacts facts;
  facts.shaping = setting_of(shaping);
  facts.extruder_mm_s = limits.most_mm_s[3];
  return facts;
}

report::ShaperKind kind_of(const std::string& kind) {
  return report::shaper_named(kind).value_or(report::ShaperKind::none);
}

}  // namespace

// ZV, ZVD: Singer and Seering 1990. EI, two-hump EI: Singhose et al. 1994 and 1997. MZV: Klipper.
std::vector<TimedImpulse> impulses_of(const ShaperChoice& shaper) {
  if (shaper.kind == "none") return {{1, 0}};
  const double root = std::sqrt(1 - shaper.damping * shaper.damping);
  const double period = 1 / (shaper.hertz * root);
  const double k = std::exp(-shaper.damping * std::numbers::pi / root);
  std::vector<TimedImpulse> impulses;
  if (shaper.kind == "zv") impulses = {{1, 0}, {k, period / 2}};
  if (shaper.kind == "zvd") impulses = {{1, 0}, {2 * k, period / 2}, {k * k, period}};
  if (shaper.kind == "mzv") {
    const double part = std::pow(k, 0.75), first = 1 - 1 / std::numbers::sqrt2;
    impulses = {{first, 0},
                {(std::numbers::sqrt2 - 1) * part, 0.375 * period},
                {first * part * part, 0.75 * period}};
  }
  if (shaper.kind == "ei") {
    impulses = {{1.05 / 4, 0}, {0.95 / 2 * k, period / 2}, {1.05 / 4 * k * k, period}};
  }
  if (shaper.kind == "2hump_ei") {
    const double v2 = 0.05 * 0.05, x = std::cbrt(v2 * (std::sqrt(1 - v2) + 1));
    const double a = (3 * x * x + 2 * x + 3 * v2) / (16 * x);
    impulses = {{a, 0},
                {(0.5 - a) * k, period / 2},
                {(0.5 - a) * k * k, period},
                {a * k * k * k, 1.5 * period}};
  }
  double sum = 0;
  for (const TimedImpulse& impulse : impulses) sum += impulse.weight;
  for (TimedImpulse& impulse : impulses) impulse.weight /= sum;
  return impulses;
}

double mean_of(const std::vector<TimedImpulse>& impulses) {
  double mean = 0;
  for (const TimedImpulse& impulse : impulses) mean += impulse.weight * impulse.seconds;
  return mean;
}

report::ShapingSetting setting_of(const ShapingChoice& choice) {
  report::ShapingSetting setting;
  const std::array<const ShaperChoice*, 2> shapers{&choice.x, &choice.y};
  for (std::size_t i = 0; i < 2; ++i) {
    setting.shapers[i] = {kind_of(shapers[i]->kind), std::llround(shapers[i]->hertz * 1000),
                          std::llround(shapers[i]->damping * 1e4)};
  }
  setting.advance_us = std::llround(choice.advance_s * 1e6);
  return setting;
}

ShapedPrinter::ShapedPrinter(double clock_hz, const ShapingChoice& shaping,
                             const PlanLimits& limits, std::size_t buffered_lines)
    : clock_hz_(clock_hz),
      shaping_(shaping),
      given_(shaping),
      limits_(limits),
      buffered_(buffered_lines),
      check_(limits.steps_per_mm, start, sim::ClockRate(static_cast<std::uint32_t>(clock_hz)),
             facts_of(shaping, limits)) {}

// 1 to 2 ms, at least 2^14 clocks; twice that where a shaper is longer than 60 of them.
double ShapedPrinter::slot_s() const {
  double clocks = 16384;
  while (clocks * 2 / clock_hz_ <= 0.002) clocks *= 2;
  const double longest =
      std::max(impulses_of(real().x).back().seconds, impulses_of(real().y).back().seconds) +
      (real().advance_s > 0 ? advance_window_s : 0);
  return (longest > 60 * clocks / clock_hz_ ? 2 : 1) * clocks / clock_hz_;
}

void ShapedPrinter::add_steps(std::vector<Edge>& edges, std::size_t axis, double begin,
                              std::int64_t steps) const {
  const double slot = slot_s_;
  const double count = static_cast<double>(std::abs(steps));
  for (std::int64_t i = 0; i < std::abs(steps); ++i) {
    const double time = begin + (static_cast<double>(i) + 0.5) / count * slot;
    edges.push_back({static_cast<std::uint64_t>(time * clock_hz_), axis, steps > 0 ? 1 : -1});
  }
}

std::vector<ShapedPrinter::Edge> ShapedPrinter::shaped_edges(const Plan& plan) const {
  const double slot = slot_s_;
  const std::array<std::vector<TimedImpulse>, 2> shapers{impulses_of(real().x),
                                                         impulses_of(real().y)};
  const double half_window = real().advance_s > 0 ? advance_window_s / 2 : 0;
  const double late =
      slot * std::ceil(std::max({mean_of(shapers[0]), mean_of(shapers[1]), half_window}) / slot);
  const double end = plan.seconds() + 2 * late + half_window +
                     std::max(shapers[0].back().seconds, shapers[1].back().seconds);
  std::vector<Edge> edges;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::vector<TimedImpulse> none{{1, 0}};
    const auto& impulses = axis < 2 ? shapers[axis] : none;
    const double mean = mean_of(impulses);
    std::vector<Plan::Cursor> cursors(impulses.size() + 2, Plan::Cursor(plan));
    std::int64_t made = std::llround(plan.ways().front().from[axis]);
    for (double time = 0; time < end + slot; time += slot) {
      const double now = time + slot - late;
      double place = 0;
      for (std::size_t i = 0; i < impulses.size(); ++i) {
        const double then = now + mean - impulses[i].seconds;
        place += impulses[i].weight * cursors[i].at(then, axis);
      }
      if (axis == 3 && half_window > 0) {
        const double printed = cursors[cursors.size() - 2].at(now + half_window, 4) -
                               cursors.back().at(now - half_window, 4);
        place += real().advance_s * printed / advance_window_s;
      }
      const std::int64_t steps = std::llround(place) - made;
      made += steps;
      add_steps(edges, axis, time, steps);
    }
  }
  std::ranges::stable_sort(edges, {}, &Edge::clock);
  return edges;
}

// Without shaping each line's steps come in the middle of their part of the line.
std::vector<ShapedPrinter::Edge> ShapedPrinter::plain_edges(const Plan& plan) const {
  std::vector<Edge> edges;
  constexpr double tick_s = 5e-5;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    Plan::Cursor cursor(plan);
    std::int64_t made = std::llround(plan.ways().front().from[axis]);
    const auto go_to = [&](double place, double time) {
      for (const std::int64_t to = std::llround(place); made != to; made += made < to ? 1 : -1) {
        edges.push_back({static_cast<std::uint64_t>(time * clock_hz_), axis, made < to ? 1 : -1});
      }
    };
    for (std::size_t way = 0; way < plan.ways().size(); ++way) {
      const double end = plan.start_of(way + 1);
      for (double time = plan.start_of(way) + tick_s; time < end; time += tick_s) {
        go_to(cursor.at(time, axis), time);
      }
      go_to(plan.ways()[way].to[axis], end);
    }
  }
  std::ranges::stable_sort(edges, {}, &Edge::clock);
  return edges;
}

void ShapedPrinter::insert_twitch(std::vector<Edge>& edges) {
  if (!twitch_ || twitch_->run != runs_) return;
  const auto index = static_cast<std::size_t>(twitch_->part * static_cast<double>(edges.size()));
  const std::uint64_t clock = edges.empty() ? 0 : edges[std::min(index, edges.size() - 1)].clock;
  std::vector<Edge> more;
  const int out = twitch_->steps > 0 ? 1 : -1;
  for (std::int64_t i = 0; i < std::abs(twitch_->steps); ++i) {
    more.push_back({clock, twitch_->axis, out});
  }
  if (!twitch_->once) {
    for (std::int64_t i = 0; i < std::abs(twitch_->steps); ++i) {
      more.push_back({clock, twitch_->axis, -out});
    }
  }
  // One after the other, and all that follow later by as much.
  for (std::size_t i = 0; i < more.size(); ++i) more[i].clock += 20 * (i + 1);
  const auto place = edges.begin() + static_cast<std::ptrdiff_t>(std::min(index + 1, edges.size()));
  for (auto edge = place; edge != edges.end(); ++edge) edge->clock += 20 * (more.size() + 2);
  edges.insert(place, more.begin(), more.end());
  twitch_.reset();
}

void ShapedPrinter::play(const Edge& edge) {
  clock_ = edge.clock;
  position_[edge.axis] += edge.direction;
  edges_.push_back(edge);
  check_.stepped({edge.clock, edge.axis, edge.direction, position_[edge.axis]});
}

void ShapedPrinter::send(const std::string& text) {
  check_.command_sent(++clock_, ++file_line_, text);
  check_.command_acknowledged(++clock_, file_line_, text, true);
}

void ShapedPrinter::run(const std::vector<Command>& commands) {
  for (std::size_t first = 0; first < commands.size();) {
    std::size_t last = first;
    while (last < commands.size() && !commands[last].waits) ++last;
    run_to_rest(commands, first, last);
    if (last < commands.size()) {
      send(commands[last].text);
      if (commands[last].shaping) shaping_ = *commands[last].shaping;
      ++last;
    }
    first = last;
  }
}

void ShapedPrinter::run_to_rest(const std::vector<Command>& commands, std::size_t first,
                                std::size_t last) {
  std::vector<Way> ways;
  std::vector<std::size_t> next_way;  // that has not begun before each command
  for (std::size_t i = first; i < last; ++i) {
    next_way.push_back(ways.size());
    for (const Way& way : commands[i].ways) {
      if (way.length_mm > 0) ways.push_back(way);
    }
    if (commands[i].pause_s >= 0 && !ways.empty()) ways.back().pause_s = commands[i].pause_s;
  }
  std::size_t sent = first;
  for (; sent < last && sent < first + buffered_; ++sent) send(commands[sent].text);
  slot_s_ = slot_s();
  std::vector<Edge> edges;
  std::vector<std::uint64_t> starts;
  const std::uint64_t begin = clock_ + 1;
  if (!ways.empty()) {
    const Plan plan(std::move(ways), limits_);
    edges = shaping_.any() ? shaped_edges(plan) : plain_edges(plan);
    for (const std::size_t way : next_way) {
      const double time = way < plan.ways().size() ? plan.start_of(way) : plan.seconds();
      starts.push_back(begin + static_cast<std::uint64_t>(time * clock_hz_));
    }
  }
  insert_twitch(edges);
  for (Edge& edge : edges) {
    edge.clock += begin;
    while (sent < last && starts[sent - first - buffered_] <= edge.clock) {
      send(commands[sent++].text);
    }
    edge.clock = std::max(edge.clock, clock_);
    play(edge);
  }
  while (sent < last) send(commands[sent++].text);
  clock_ += static_cast<std::uint64_t>(0.3 * clock_hz_);
  rests_.push_back({position_, last, edges_.size()});
  ++runs_;
}

}  // namespace tests
