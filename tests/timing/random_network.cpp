// SPDX-License-Identifier: Apache-2.0
// Each part of a program is added to the network, and its times to those of its parts.
#include "tests/timing/random_network.hpp"

#include <algorithm>

namespace timing {

namespace {

class Generator {
 public:
  explicit Generator(std::mt19937& random) : random_(random) {}

  RandomNetwork make() {
    const Times times = add_part(4);
    network_.end = here_;
    for (RoundsBound& loop : network_.loops) loop.nodes.resize(network_.end);
    network_.entry_begins = {0, 1};
    Networks networks{{std::move(network_)}, {{0, below(5)}, {1, below(5)}}};
    return {std::move(networks), times};
  }

 private:
  std::uint32_t below(std::uint32_t end) {
    return std::uniform_int_distribution<std::uint32_t>(0, end - 1)(random_);
  }

  static void keep(Times& times, std::pair<Clocks, Clocks> events, Clocks clocks) {
    Clocks& known = times[events];
    known = std::max(known, clocks);
  }

  static Times after(const Times& first, const Times& second) {
    Times times;
    for (const auto& [events, clocks] : first) {
      for (const auto& [more, other] : second) {
        keep(times, {events.first + more.first, events.second + more.second}, clocks + other);
      }
    }
    return times;
  }

  Times add_arc(std::size_t from, std::size_t to) {
    Arc arc;
    arc.from = from;
    arc.to = to;
    arc.clocks = below(20);
    std::pair<Clocks, Clocks> events;
    if (below(4) == 0) {
      arc.events.push_back(0);
      ++events.first;
    }
    if (below(4) == 0) {
      arc.events.push_back(1);
      ++events.second;
    }
    const Times times{{events, arc.clocks}};
    network_.arcs.push_back(std::move(arc));
    return times;
  }

  // Goes on from `here_`.
  Times add_part(unsigned depth) {
    switch (depth == 0 ? 0 : below(4)) {
      case 0:
        return add_step();
      case 1: {
        const Times first = add_part(depth - 1);
        return after(first, add_part(depth - 1));
      }
      case 2:
        return add_choice(depth);
      default:
        return add_loop(depth);
    }
  }

  Times add_step() {
    const std::size_t from = here_++;
    return add_arc(from, here_);
  }

  Times add_choice(unsigned depth) {
    const std::size_t fork = here_++;
    Times one = add_arc(fork, here_);
    one = after(one, add_part(depth - 1));
    const std::size_t end_of_one = here_++;
    Times other = add_arc(fork, here_);
    other = after(other, add_part(depth - 1));
    const std::size_t end_of_other = here_++;
    one = after(one, add_arc(end_of_one, here_));
    other = after(other, add_arc(end_of_other, here_));
    for (const auto& [events, clocks] : one) keep(other, events, clocks);
    return other;
  }

  Times add_loop(unsigned depth) {
    const std::size_t before = here_++;
    const std::size_t header = here_;
    const Times entry = add_arc(before, header);
    here_ = header + 1;
    Times round = add_arc(header, here_);
    round = after(round, add_part(depth - 1));
    const std::size_t last = here_++;
    round = after(round, add_arc(last, header));
    const Times exit = add_arc(header, here_);
    RoundsBound loop{.header = header, .nodes = std::vector<bool>(last + 1), .most = below(4)};
    for (std::size_t node = header; node <= last; ++node) loop.nodes[node] = true;
    Times all = entry, rounds = entry;
    for (Clocks i = 0; i < loop.most; ++i) {
      rounds = after(rounds, round);
      for (const auto& [events, clocks] : rounds) keep(all, events, clocks);
    }
    network_.loops.push_back(std::move(loop));
    return after(all, exit);
  }

  std::mt19937& random_;
  Network network_;
  std::size_t here_ = 0;
};

}  // namespace

bool RandomNetwork::has_path() const {
  return std::ranges::any_of(times, [&](const auto& time) {
    return time.first.first <= networks.facts[0].most &&
           time.first.second <= networks.facts[1].most;
  });
}

Clocks RandomNetwork::longest() const {
  Clocks longest = 0;
  for (const auto& [events, clocks] : times) {
    if (events.first > networks.facts[0].most || events.second > networks.facts[1].most) continue;
    longest = std::max(longest, clocks);
  }
  return longest;
}

RandomNetwork random_network(std::mt19937& random) { return Generator(random).make(); }

}  // namespace timing
