// SPDX-License-Identifier: Apache-2.0
// Samples the statistics of the chip.
#include "sim/report/chip_record.hpp"

#include <algorithm>

namespace report {

ChipRecord::ChipRecord(const sim::Chip& chip, sim::ClockRate rate)
    : chip_(chip),
      rate_(rate),
      look_clocks_(std::max<sim::Clock>(1, rate.clocks(look_seconds))),
      underruns_(chip.queue_statistics().underruns),
      load_since_(chip.now()),
      sleeping_clocks_(chip.processor_statistics().sleeping_clocks) {
  const double look = rate.seconds(look_clocks_);
  course_.queue_depth = RangeCourse(look);
  course_.processor_busy_percent = RangeCourse(look * looks_per_load);
  next_wake_ = look_clocks_;
}

void ChipRecord::wake(sim::Clock now) {
  next_wake_ = now + look_clocks_;
  const sim::QueueStatistics queue = chip_.queue_statistics();
  course_.queue_depth.put(queue.depth);
  if (queue.underruns > underruns_) {
    if (course_.underruns.size() < most_underruns) {
      course_.underruns.push_back({rate_.seconds(now), queue.underruns - underruns_});
    } else {
      course_.underruns.back().count += queue.underruns - underruns_;
    }
  }
  underruns_ = queue.underruns;  // a reset of the chip begins at 0
  if (++looks_ % looks_per_load == 0) put_load(now);
}

void ChipRecord::put_load(sim::Clock now) {
  const std::uint64_t sleeping = chip_.processor_statistics().sleeping_clocks;
  const auto passed = static_cast<double>(now - load_since_);
  const auto slept = static_cast<double>(sleeping - sleeping_clocks_);
  course_.processor_busy_percent.put(100.0 * (1.0 - slept / passed));
  load_since_ = now;
  sleeping_clocks_ = sleeping;
}

}  // namespace report
