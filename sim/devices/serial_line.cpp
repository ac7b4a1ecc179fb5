// SPDX-License-Identifier: Apache-2.0
// Bits on the wire in both directions; bit times are counted from the first start bit after a
// pause, so that no rounding adds up.
#include "sim/devices/serial_line.hpp"

#include <algorithm>

#include "sim/simulation/activity.hpp"

namespace devices {

namespace {
constexpr unsigned frame_bits = 10;  // start, 8 data, stop
constexpr unsigned rest = frame_bits + 1;  // no frame is on the wire
}  // namespace

SerialLine::SerialLine(sim::ClockRate rate, std::uint32_t baud, sim::InputPins& inputs,
                       const SerialFaults& faults)
    : rate_(rate),
      baud_(baud),
      inputs_(inputs),
      faults_(faults),
      random_(faults.seed),
      reply_random_(faults.seed + 1) {
  inputs_.receive = true;
}

void SerialLine::send(sim::Clock now, std::string_view bytes) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  if (!sending_ && !waiting_.empty()) {
    send_start_ = now;
    frames_since_start_ = 0;
    start_frame(now);
  }
  schedule();
}

void SerialLine::set_baud(sim::Clock now, std::uint32_t baud) {
  baud_ = baud;
  receiving_ = false;
  receive_at_ = sim::never;
  waiting_.clear();
  if (sending_ && sent_bits_ != rest) {
    // The line is idle for a frame, so that the chip can resynchronise.
    inputs_.receive = true;
    rest_until(after_half_bits(now, 2 * frame_bits));
  }
  schedule();
}

void SerialLine::hang_up(sim::Clock now, sim::Clock low_for) {
  waiting_.clear();
  inputs_.receive = !connected_;
  sending_ = true;
  rest_until(now + low_for);
  schedule();
}

// Then it begins with the bytes queued until then.
void SerialLine::rest_until(sim::Clock end) {
  sent_bits_ = rest;
  send_at_ = end;
}

void SerialLine::connect(bool connected) {
  connected_ = connected;
  if (!connected) {
    inputs_.receive = true;
    transmit_level_ = true;
  }
}

std::uint8_t SerialLine::with_noise(std::uint8_t byte, std::mt19937_64& random, double share,
                                    std::uint64_t& count) {
  if (share <= 0 || !std::bernoulli_distribution(share)(random)) return byte;
  ++count;
  return static_cast<std::uint8_t>(byte ^ (1U << (random() % 8)));
}

sim::Clock SerialLine::after_half_bits(sim::Clock start, std::uint64_t half_bits) const {
  const std::uint64_t per_half_bit = std::uint64_t{2} * baud_;
  return start + (half_bits * rate_.hertz() + per_half_bit / 2) / per_half_bit;
}

void SerialLine::schedule() { next_wake_ = std::min(send_at_, receive_at_); }

void SerialLine::start_frame(sim::Clock now) {
  const std::uint8_t byte =
      with_noise(waiting_.front(), random_, faults_.corrupted_bytes, bytes_corrupted_);
  waiting_.pop_front();
  send_frame_ = static_cast<std::uint16_t>(unsigned{byte} << 1 | 1U << (frame_bits - 1));
  sending_ = true;
  sent_bits_ = 0;
  drive_next_bit(now);
}

// The next byte, if one waits.
void SerialLine::go_on(sim::Clock now) {
  if (!waiting_.empty()) return start_frame(now);
  sending_ = false;
  send_at_ = sim::never;
  if (listener_ == nullptr) return;
  const sim::ActivityScope scope(sim::Activity::host_and_report);
  listener_->all_sent(now);
}

// A break is followed by a frame's time of the level at rest.
void SerialLine::end_rest(sim::Clock now) {
  if (!inputs_.receive) {
    inputs_.receive = true;
    return rest_until(after_half_bits(now, 2 * frame_bits));
  }
  send_start_ = now;
  frames_since_start_ = 0;
  go_on(now);
}

// Drives the bit that begins now and requests the next time at which the level changes.
void SerialLine::drive_next_bit(sim::Clock now) {
  if (sent_bits_ == rest) return end_rest(now);
  if (sent_bits_ == frame_bits) {
    ++(connected_ ? bytes_sent_ : bytes_lost_);
    ++frames_since_start_;
    return go_on(now);
  }
  const bool level = (send_frame_ >> sent_bits_ & 1) != 0;
  inputs_.receive = level || !connected_;
  do {
    ++sent_bits_;
  } while (sent_bits_ < frame_bits && ((send_frame_ >> sent_bits_ & 1) != 0) == level);
  send_at_ = after_half_bits(send_start_, 2 * (frames_since_start_ * frame_bits + sent_bits_));
}

void SerialLine::pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins) {
  transmit_level_ = pins.transmit() || !connected_;
  if (!receiving_ && !transmit_level_) {
    receiving_ = true;
    received_bits_ = 0;
    receive_frame_ = 0;
    receive_start_ = now;
    receive_at_ = after_half_bits(now, 1);
    schedule();
  }
}

void SerialLine::sample_bit(sim::Clock now) {
  if (transmit_level_) {
    receive_frame_ = static_cast<std::uint16_t>(receive_frame_ | 1U << received_bits_);
  }
  ++received_bits_;
  if (received_bits_ < frame_bits) {
    receive_at_ = after_half_bits(receive_start_, 2 * received_bits_ + 1);
    return;
  }
  receiving_ = false;
  receive_at_ = sim::never;
  if ((receive_frame_ & 1U) != 0 || (receive_frame_ >> (frame_bits - 1) & 1U) == 0) {
    ++framing_errors_;
    return;
  }
  ++bytes_received_;
  const std::uint8_t byte =
      with_noise(static_cast<std::uint8_t>(receive_frame_ >> 1), reply_random_,
                 faults_.corrupted_replies, replies_corrupted_);
  if (listener_ == nullptr) return;
  const sim::ActivityScope scope(sim::Activity::host_and_report);
  listener_->byte_received(now, byte);
}

void SerialLine::wake(sim::Clock now) {
  if (receive_at_ <= now) sample_bit(now);
  if (send_at_ <= now) drive_next_bit(now);
  schedule();
}

}  // namespace devices
