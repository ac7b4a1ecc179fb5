// SPDX-License-Identifier: Apache-2.0
// Any sequence of moves ends, and is in between, on the step that exact arithmetic says.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/exact_moves/command_chain.hpp"
#include "tests/exact_moves/random_lines.hpp"

namespace exact_moves {
namespace {

using StepsPerMeter = std::array<std::int32_t, axis_count>;

// The default machine; awkward ratios; the finest and the coarsest that M92 takes.
constexpr std::array<StepsPerMeter, 4> machines{{{80'000, 80'000, 2'560'000, 500'000},
                                                 {62'745, 118'577, 2'267'718, 836'127},
                                                 {3'200'000, 999'983, 10'000'000, 7'777'777},
                                                 {1'001, 10'000, 17, 2'003}}};
constexpr double largest_mm = 100;

std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

class Trial {
 public:
  explicit Trial(const StepsPerMeter& steps_per_meter)
      : axes_(steps_per_meter), chain_(steps_per_meter) {}

  void take(const std::string& line) {
    axes_.take(line);
    chain_.take(line);
    text_ += line + "\n";
  }

  // What is planned is executed; then the counters are compared.
  [[nodiscard]] bool is_exact() {
    chain_.settle();
    EXPECT_EQ(chain_.steps(), axes_.steps()) << text_;
    EXPECT_EQ(chain_.notices, "") << text_;
    EXPECT_EQ(chain_.broken_lines(), 0u) << text_;
    return !testing::Test::HasFailure();
  }

  void begin_sequence() { text_.clear(); }
  const ExactAxes& axes() const { return axes_; }

 private:
  ExactAxes axes_;
  CommandChain chain_;
  std::string text_;
};

TEST(exact_moves, of_less_than_a_step_add_up) {
  Trial trial(machines[0]);
  trial.take("G1 X20");
  for (int i = 1; i <= 200; ++i) trial.take("G1 X20." + std::to_string(1'000 + 5 * i).substr(1));
  trial.take("G1 X21.0");
  ASSERT_TRUE(trial.is_exact());
  trial.take("G1 X20");
  ASSERT_TRUE(trial.is_exact());
  trial.take("M83");
  for (int i = 0; i < 680; ++i) trial.take("G1 E0.001");
  ASSERT_TRUE(trial.is_exact());
  EXPECT_EQ(trial.axes().steps()[0], 1'600);
  EXPECT_EQ(trial.axes().steps()[3], 340);
}

// EXACT_MOVES_SEQUENCES and EXACT_MOVES_SEED choose more, or others.
TEST(exact_moves, in_random_sequences_reach_every_step) {
  const std::uint64_t sequences = number_from_environment("EXACT_MOVES_SEQUENCES", 200'000);
  const std::uint64_t seed = number_from_environment("EXACT_MOVES_SEED", 1);
  constexpr std::uint64_t sequences_per_trial = 500;
  std::uint64_t lines = 0, comparisons = 0;
  for (std::uint64_t done = 0; done < sequences; done += sequences_per_trial) {
    Trial trial(machines[done / sequences_per_trial % machines.size()]);
    RandomLines random(seed * 1'000'003 + done, largest_mm);
    std::mt19937_64 choice(seed + done);
    for (std::uint64_t i = 0; i < std::min(sequences_per_trial, sequences - done); ++i) {
      trial.begin_sequence();
      for (std::uint64_t left = 4 + choice() % 20; left > 0; --left, ++lines) {
        trial.take(random.next(trial.axes()));
        if (choice() % 8 != 0) continue;
        ++comparisons;
        ASSERT_TRUE(trial.is_exact()) << "sequence " << done + i;
      }
      ++comparisons;
      ASSERT_TRUE(trial.is_exact()) << "sequence " << done + i;
    }
  }
  std::printf("%lu sequences, %lu lines, %lu comparisons of all axes: no difference\n", sequences,
              lines, comparisons);
}

}  // namespace
}  // namespace exact_moves
