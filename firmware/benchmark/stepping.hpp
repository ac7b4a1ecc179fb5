// SPDX-License-Identifier: Apache-2.0
// What the simulation asks of the stepping benchmark's program, and its answer: words in memory,
// found by the symbols benchmark_order and benchmark_result.
#pragma once

#include <array>
#include <cstdint>

namespace benchmark {

// A segment (motion/segment.hpp), in words.
struct Piece {
  std::array<std::int32_t, 4> steps{};
  std::uint32_t line_ticks{};
  std::uint32_t ticks{};
  std::uint32_t continues_line{};
  std::uint32_t rate_low{}, rate_high{};
  std::uint32_t acceleration_low{}, acceleration_high{};
};

struct SteppingOrder {
  static constexpr std::size_t most_pieces = 8;

  std::uint32_t guard_high{1}, guard_low{1}, guard_setup{1}, guard_hold{1};  // clocks
  std::uint32_t baud{};  // 0: the serial line is left alone; otherwise what comes in goes back
  std::uint32_t wake_clocks{};  // the program looks after the queue at least so often
  std::uint32_t repetitions{};  // of all pieces
  std::uint32_t piece_count{};
  std::array<Piece, most_pieces> pieces{};
};

struct SteppingResult {
  std::uint32_t done{};
  std::uint32_t refused{};  // segments
  std::uint32_t segments{};
  std::uint32_t underruns{};
  std::uint32_t stall_clocks{};
  std::uint32_t bytes_lost{};
};

static_assert(sizeof(SteppingOrder) == 4 * (8 + 11 * SteppingOrder::most_pieces));
static_assert(sizeof(SteppingResult) == 4 * 6);

}  // namespace benchmark
