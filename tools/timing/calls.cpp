// SPDX-License-Identifier: Apache-2.0
// Calls and returns, followed by the addresses at which they go on.
#include "tools/timing/calls.hpp"

#include <algorithm>
#include <stdexcept>

namespace timing {

using processor::Operation;

void Calls::take(const Sample& sample) {
  if (last_ && sample.instructions > last_->instructions + 1) {
    throw std::runtime_error("two instructions in a clock");
  }
  if (last_ && sample.instructions != last_->instructions) {
    if (places_.contains(sample.program_counter)) pass_spans(sample);
    jump(*last_, sample);
  }
  last_ = sample;
}

void Calls::watch(std::uint32_t number, const std::set<Address>& begins,
                  const std::set<Address>& ends) {
  spans_[number] = {.begins = begins, .ends = ends, .began = {}, .measured = {}};
  places_.insert(begins.begin(), begins.end());
  places_.insert(ends.begin(), ends.end());
}

void Calls::pass_spans(const Sample& behind) {
  const Address place = behind.program_counter;
  for (auto& [number, span] : spans_) {
    if (span.began && span.ends.contains(place)) {
      const std::uint64_t clocks = behind.begins - *span.began - (behind.slept - span.slept);
      ++span.measured.calls;
      span.measured.longest = std::max(span.measured.longest, clocks);
      span.began.reset();
    }
    if (!span.began && span.begins.contains(place)) {
      span.began = behind.begins;
      span.slept = behind.slept;
    }
  }
}

void Calls::jump(const Sample& before, const Sample& behind) {
  const Address address = before.program_counter;
  if (!program_.is_code(address)) return;
  const auto instruction = processor::decode(program_.word_at(address), address, has_zbb_);
  const bool is_jump = instruction.operation == Operation::jump;
  if (!is_jump && instruction.operation != Operation::jump_register) return;
  const unsigned link = instruction.destination;
  const Address target = behind.program_counter;
  if (link == return_register || link == second_link) {
    frames_.push_back({target, address + instruction.bytes, behind.begins, behind.slept});
  } else if (is_jump) {
    // In place of a return.
    const bool is_function = program_.symbols.contains(target);
    if (is_function && !frames_.empty() && frames_.back().function != target) {
      frames_.push_back({target, frames_.back().back, behind.begins, behind.slept});
    }
  } else if (!frames_.empty() && instruction.immediate == 0) {
    end(target, behind.begins, behind.slept);
  }
}

void Calls::end(Address back, std::uint64_t begins, std::uint64_t slept) {
  if (frames_.back().back != back) {
    ++strays_;
    frames_.clear();
  }
  while (!frames_.empty() && frames_.back().back == back) {
    const Frame& frame = frames_.back();
    Measured& measured = measured_[frame.function];
    ++measured.calls;
    measured.longest = std::max(measured.longest, begins - frame.begins - (slept - frame.slept));
    frames_.pop_back();
  }
}

}  // namespace timing
