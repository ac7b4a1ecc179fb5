// SPDX-License-Identifier: Apache-2.0
// Plans of the fake chip in order of time, and its serial line.
#include "tests/sim/fake_chip.hpp"

#include <algorithm>

namespace tests {

namespace {
constexpr std::size_t memory_words = 16'384;
}

FakeChip::FakeChip(sim::Clock clocks_per_bit)
    : clocks_per_bit_(clocks_per_bit), memory_(memory_words) {
  outputs_.word = sim::OutputPins::transmit_pin().word;
}

void FakeChip::plan(sim::Clock clock, unsigned bit, bool level) {
  plans_.emplace(clock, [this, bit, level] {
    const std::uint64_t mask = sim::OutputPins::bit(bit);
    outputs_.word = level ? outputs_.word | mask : outputs_.word & ~mask;
  });
}

void FakeChip::plan_step(sim::Clock clock, std::size_t axis, bool backward, sim::Clock high,
                         sim::Clock setup) {
  const auto shift = static_cast<unsigned>(axis);
  plan(clock - setup, sim::OutputPins::direction_bit + shift, backward);
  plan(clock, sim::OutputPins::step_bit + shift, true);
  plan(clock + high, sim::OutputPins::step_bit + shift, false);
}

void FakeChip::say(const std::string& text) {
  line_free_at_ = std::max(line_free_at_, now_ + 1);
  for (const char character : text) {
    const unsigned frame = 1U << 9 | static_cast<unsigned>(static_cast<unsigned char>(character))
                                         << 1;
    for (unsigned bit = 0; bit < 10; ++bit) {
      plan(line_free_at_, sim::OutputPins::transmit_bit, (frame >> bit & 1) != 0);
      line_free_at_ += clocks_per_bit_;
    }
  }
}

void FakeChip::watch_receive_pin() {
  if (!receiving_ && !inputs_.receive) {
    receiving_ = true;
    bits_ = 0;
    frame_ = 0;
    plans_.emplace(now_ + clocks_per_bit_ / 2, [this] { receive_bit(); });
  }
}

void FakeChip::receive_bit() {
  frame_ |= (inputs_.receive ? 1U : 0U) << bits_;
  if (++bits_ < 10) {
    plans_.emplace(now_ + clocks_per_bit_, [this] { receive_bit(); });
    return;
  }
  if (frame_ == 0) {
    // A break: what is unfinished is given up, as by the firmware. It ends with the level at rest.
    line_.clear();
    ++breaks;
    plans_.emplace(now_ + clocks_per_bit_, [this] { wait_for_rest(); });
    return;
  }
  receiving_ = false;
  const char byte = static_cast<char>(frame_ >> 1 & 0xff);
  if (byte != '\n') {
    line_ += byte;
    return;
  }
  const std::string line = std::exchange(line_, {});
  if (firmware) say(firmware(line));
}

void FakeChip::wait_for_rest() {
  receiving_ = !inputs_.receive;
  if (receiving_) plans_.emplace(now_ + clocks_per_bit_, [this] { wait_for_rest(); });
}

void FakeChip::advance(sim::Clock limit) {
  watch_receive_pin();
  if (plans_.empty() || plans_.begin()->first > limit) {
    now_ = limit;
    return;
  }
  now_ = std::max(now_ + 1, plans_.begin()->first);
  while (!plans_.empty() && plans_.begin()->first <= now_) {
    const auto action = plans_.begin()->second;
    plans_.erase(plans_.begin());
    action();
  }
}

std::uint32_t FakeChip::read_memory(std::uint32_t address) const {
  return memory_.at((address - memory_start) / 4);
}

void FakeChip::write_memory(std::uint32_t address, std::uint32_t word) {
  memory_.at((address - memory_start) / 4) = word;
}

}  // namespace tests
