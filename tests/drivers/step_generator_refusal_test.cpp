// SPDX-License-Identifier: Apache-2.0
// Segments that the step generator refuses, after which it takes the next good one.
#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using motion::Segment;
using testing::ElementsAre;
using units::Axis;

class StepGeneratorRefusalTest : public tests::StepGeneratorFixture {};

TEST_F(StepGeneratorRefusalTest, refuses_an_axis_both_early_and_late) {
  Segment segment = line({5, 3, 0, 0});
  segment.start.ahead.insert(Axis::y);
  segment.start.behind.insert(Axis::y);
  EXPECT_FALSE(generator_.append(segment));
  segment.start.behind.remove(Axis::y);
  segment.start.behind.insert(Axis::x);
  append(segment);
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(5, 3, 0, 0, 0));
}

TEST_F(StepGeneratorRefusalTest,
       refuses_segments_that_cannot_be_executed_and_takes_the_next_good_one) {
  Segment no_ticks = line({5, 0, 0, 0});
  no_ticks.ticks = 0;
  EXPECT_FALSE(generator_.append(no_ticks));
  Segment too_many_ticks = line({5, 0, 0, 0});
  too_many_ticks.ticks = 6;
  EXPECT_FALSE(generator_.append(too_many_ticks));
  Segment too_many_steps = line({5, 0, 0, 0});
  too_many_steps.steps[3] = -6;
  EXPECT_FALSE(generator_.append(too_many_steps));
  EXPECT_FALSE(generator_.append(line({5, 0, 0, 0}, half + 1)));
  Segment line_of_none = line({5, 0, 0, 0});
  line_of_none.continues_line = true;
  EXPECT_FALSE(generator_.append(line_of_none));
  EXPECT_EQ(generator_.queued_segments(), 0);
  append(line({5, 0, 0, 0}));
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(5, 0, 0, 0, 0));
}

TEST_F(StepGeneratorRefusalTest, refuses_more_ticks_than_are_left_of_a_line) {
  Segment part = line({10, 0, 0, 0});
  part.ticks = 7;
  append(part);
  part.continues_line = true;
  part.ticks = 4;
  EXPECT_FALSE(generator_.append(part));
  part.ticks = 3;
  append(part);
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], 10);
}

TEST_F(StepGeneratorRefusalTest, refuses_a_segment_when_the_queue_is_full) {
  generator_.permit_motion(false);
  for (std::uint32_t i = 0; i < generator_.queue_depth(); ++i) append(line({1, 0, 0, 0}));
  EXPECT_EQ(generator_.free_segments(), 0);
  EXPECT_FALSE(generator_.append(line({1, 0, 0, 0})));
  generator_.permit_motion(true);
  run_until_idle();
  EXPECT_EQ(pulses_.counts()[0], generator_.queue_depth());
}

}  // namespace
