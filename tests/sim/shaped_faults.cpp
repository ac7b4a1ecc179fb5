// SPDX-License-Identifier: Apache-2.0
// Faults in ways, and the order of the lines' ends.
#include "shaped_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tests {

namespace {

void measure(Way& way, const PlanLimits& limits) {
  Axes by{};
  for (std::size_t i = 0; i < 4; ++i) by[i] = (way.to[i] - way.from[i]) / limits.steps_per_mm[i];
  way.length_mm = std::hypot(by[0], by[1], by[2]);
  if (way.length_mm == 0) way.length_mm = std::abs(by[3]);
  way.prints = by[3] > 0 && (by[0] != 0 || by[1] != 0);
}

// Each way begins where the one before it ended.
void connect(std::vector<Command>& commands, const Axes& start, const PlanLimits& limits) {
  Axes place = start;
  for (Command& command : commands) {
    for (Way& way : command.ways) {
      if (way.from != place || way.length_mm == 0) {
        way.from = place;
        measure(way, limits);
      }
      place = way.to;
    }
  }
}

bool moves(const Command& command) {
  return std::ranges::any_of(command.ways, [](const Way& way) { return way.from != way.to; });
}

}  // namespace

std::string name_of(Fault fault) {
  constexpr std::array names{"left out",      "swapped",      "end off by one", "axis off",
                             "much filament", "late Z",       "forth and back", "moved after end",
                             "slow shaper",   "long advance", "too fast"};
  return names[static_cast<std::size_t>(fault)];
}

std::vector<Command> faulty(Fault fault, const std::vector<Command>& commands,
                            const PlanLimits& limits, std::mt19937& random) {
  std::vector<Command> changed = commands;
  const auto pick = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  std::vector<std::size_t> places;  // commands that move
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (moves(commands[i])) places.push_back(i);
  }
  const Axes start = commands[places.front()].ways.front().from;
  const std::size_t at = pick(places.size());
  Command& chosen = changed[places[at]];
  // The motion that it is part of, from rest to rest.
  std::size_t first = at, last = at;
  const auto rests_before = [&](std::size_t place) {
    return std::any_of(commands.begin() + static_cast<std::ptrdiff_t>(places[place - 1]),
                       commands.begin() + static_cast<std::ptrdiff_t>(places[place]),
                       [](const Command& command) { return command.waits; });
  };
  while (first > 0 && !rests_before(first)) --first;
  while (last + 1 < places.size() && !rests_before(last + 1)) ++last;
  const std::size_t axis = pick(4);
  switch (fault) {
    case Fault::left_out:
      chosen.ways.clear();
      break;
    case Fault::swapped: {
      if (at + 1 >= places.size()) return {};
      Command& next = changed[places[at + 1]];
      if (chosen.ways.size() != 1 || next.ways.size() != 1) return {};
      Way& way = chosen.ways[0];
      for (std::size_t i = 0; i < 4; ++i) {
        way.to[i] = way.from[i] + next.ways[0].to[i] - next.ways[0].from[i];
      }
      break;
    }
    case Fault::end_off_by_one:
      changed[places[last]].ways.back().to[axis] += pick(2) == 0 ? 1 : -1;
      break;
    case Fault::axis_off: {
      if (first == last) return {};
      const double off = static_cast<double>(pick(200)) - 100;
      for (std::size_t i = first; i < last; ++i) {
        for (Way& way : changed[places[i]].ways) way.to[axis] += off;
      }
      break;
    }
    case Fault::too_much_filament: {
      if (first == last) return {};
      const double part = pick(2) == 0 ? 1.2 : 0.8,
                   origin = commands[places[first]].ways[0].from[3];
      for (std::size_t i = first; i < last; ++i) {
        for (Way& way : changed[places[i]].ways) {
          way.to[3] = std::round(origin + part * (way.to[3] - origin));
        }
      }
      break;
    }
    case Fault::late_z: {
      std::size_t hop = 0;
      while (hop < places.size() &&
             commands[places[hop]].ways.back().to[2] == commands[places[hop]].ways[0].from[2]) {
        ++hop;
      }
      if (hop + 1 >= places.size() || commands[places[hop]].ways.size() != 1) return {};
      changed[places[hop]].ways[0].to[2] = changed[places[hop]].ways[0].from[2];
      break;
    }
    case Fault::moved_after_end: {
      Way way{.from = commands[places.back()].ways.back().to, .speed_mm_s = 30, .pause_s = -1};
      way.to = way.from;
      way.to[axis] += static_cast<double>(1 + pick(300));
      measure(way, limits);
      changed.back().ways.push_back(way);
      if (changed.back().waits) return {};
      break;
    }
    case Fault::too_fast:
      for (Command& command : changed) {
        for (Way& way : command.ways) way.speed_mm_s *= 5;
      }
      break;
    case Fault::forth_and_back:
    case Fault::slow_shaper:
    case Fault::long_advance:
    case Fault::count:
      break;
  }
  connect(changed, start, limits);
  return changed;
}

// Speeds are between those of F both ways. An impulse at a time t from their mean puts the axis off
// by up to speed * t; a slot of time, by what it moves in it; three steps round.
Axes tolerance_of(const std::vector<Command>& commands, const ShapingChoice& shaping,
                  double slot_s) {
  Axes speeds{};
  for (const Command& command : commands) {
    for (const Way& way : command.ways) {
      if (way.length_mm == 0) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const double speed = std::abs(way.to[i] - way.from[i]) / way.length_mm * way.speed_mm_s;
        speeds[i] = std::max(speeds[i], speed);
      }
    }
  }
  const std::array shapers{impulses_of(shaping.x), impulses_of(shaping.y)};
  Axes tolerance{};
  for (std::size_t i = 0; i < 4; ++i) {
    double time = slot_s;
    for (const TimedImpulse& impulse : shapers[i % 2]) {
      if (i < 2) time += impulse.weight * std::abs(impulse.seconds - mean_of(shapers[i]));
    }
    if (i == 3) time += shaping.advance_s;
    tolerance[i] = 3 + speeds[i] * time;
  }
  return tolerance;
}

bool passes(const std::vector<Command>& commands, const ShapedPrinter& printer,
            const Axes& tolerance) {
  std::array<double, 4> place{};
  for (std::size_t i = 0; i < 4; ++i) place[i] = static_cast<double>(ShapedPrinter::start[i]);
  Axes end = place;
  std::size_t next = 0, edge = 0;  // a command whose end is still to be passed
  for (const auto& rest : printer.rests()) {
    for (;;) {
      for (; next < rest.command; ++next) {
        if (!commands[next].ways.empty()) end = commands[next].ways.back().to;
        bool near = true;
        for (std::size_t i = 0; i < 4; ++i) near &= std::abs(end[i] - place[i]) <= tolerance[i];
        if (!near) break;
      }
      if (edge == rest.edges) break;
      const auto& step = printer.edges()[edge++];
      place[step.axis] += step.direction;
    }
    if (next < rest.command || place != end) return false;
  }
  return true;
}

// What the judge says; empty where all is good.
std::string complaint_of(const ShapedPrinter& printer, const std::vector<Command>& commands) {
  const auto judgement = printer.check().judgement();
  const auto moves = static_cast<std::uint64_t>(std::ranges::count_if(commands, &Command::is_move));
  std::string text;
  if (judgement.missed > 0 && !judgement.list.empty()) {
    text +=
        fmt::format("missed {} first {} '{}' at {:.4f} s; ", judgement.missed,
                    judgement.list[0].file_line, judgement.list[0].text, judgement.list[0].seconds);
    for (const auto& axis : judgement.list[0].axes) {
      text += fmt::format("{}/{} ", axis.reached_steps, axis.wanted_steps);
    }
  }
  if (judgement.reached != moves) {
    text += fmt::format("reached {} of {}; ", judgement.reached, moves);
  }
  for (const auto steps : judgement.unasked_steps) {
    if (steps != 0) text += fmt::format("unasked {}; ", steps);
  }
  for (const bool moved : judgement.moved_after_end) {
    if (moved) text += "moved after the end; ";
  }
  return text;
}

}  // namespace tests
