// SPDX-License-Identifier: Apache-2.0
// One instruction after the other, by the address at which each goes on.
#include "tools/timing/cost_sum.hpp"

#include <fmt/format.h>

namespace timing {

void CostSum::take(const Sample& sample) {
  if (last_ && sample.instructions != last_->instructions) {
    execute(sample);
    accesses_ = false;
  }
  accesses_ = accesses_ || sample.accesses;
  last_ = sample;
}

void CostSum::execute(const Sample& behind) {
  const Address address = last_->program_counter;
  if (!program_.is_code(address)) {
    ++outside_;
    before_.reset();
    return;
  }
  // What is before this one is not known, nor when it could begin.
  if (!before_) {
    before_ = address;
    slept_before_ = behind.slept;
    return;
  }
  const auto at = [&](Address place) {
    return processor::decode(program_.word_at(place), place, has_zbb_);
  };
  const auto instruction = at(address);
  const bool goes_on_elsewhere = behind.program_counter != address + instruction.bytes;
  // An access where the analysis expects none is a difference.
  const bool on_bus = accesses_ && program_.may_access_bus(address);
  const std::uint64_t costs =
      costs_.of(instruction, goes_on_elsewhere, on_bus) + costs_.between(at(*before_), instruction);
  const std::uint64_t slept = behind.slept - slept_before_;
  const std::uint64_t clocks = behind.begins - last_->begins - slept;
  ++instructions_;
  sum_ += costs;
  clocks_ += clocks;
  slept_ += slept;
  if (costs != clocks) {
    ++differences_;
    if (!first_) first_ = {.address = address, .costs = costs, .clocks = clocks};
  }
  before_ = address;
  slept_before_ = behind.slept;
}

std::string CostSum::text() const {
  const auto difference = static_cast<std::int64_t>(sum_) - static_cast<std::int64_t>(clocks_);
  std::string text = fmt::format(
      "{} instructions: costs {}, mcycle {} clocks, difference {}; asleep {} clocks; "
      "{} instructions of the boot loader\n",
      instructions_, sum_, clocks_, difference, slept_, outside_);
  if (first_) {
    text += fmt::format("{} instructions differ; the first, in {} at {:#x}, costs {} and took {}\n",
                        differences_, program_.name_of(first_->address), first_->address,
                        first_->costs, first_->clocks);
  }
  return text;
}

}  // namespace timing
