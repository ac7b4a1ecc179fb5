// SPDX-License-Identifier: Apache-2.0
// What the next start needs: a bed that is clear, and filament.
#include <algorithm>
#include <cstdlib>

#include "host/queue/now.hpp"
#include "host/spooler/spooler.hpp"

namespace spooler {

// What a person has said long ago may not be so any more. True where it has ended.
bool Spooler::end_clear_bed(const std::string& printer) {
  const std::int64_t limit = settings_.bed_clear_limit.count();
  if (limit == 0) return false;
  const auto since = queue_.clear_since(printer);
  if (!since || std::abs(queue::now_ms() - *since) <= limit) return false;
  queue_.set_bed_clear(printer, false);
  return true;
}

// In mm, as planned, for the part of its commands that were sent.
double Spooler::filament_used(const queue::Job& job, const FeederState& state) const {
  if (job.commands <= 0) return job.filament_mm;
  std::int64_t done = state.phase == "finished" ? job.commands : state.done;
  const auto seen = progress_.find(job.printer);
  if (seen != progress_.end() && seen->second.job == job.id) {
    done = std::max(done, seen->second.done) - seen->second.since;
  }
  return job.filament_mm * static_cast<double>(done) / static_cast<double>(job.commands);
}

}  // namespace spooler
