// SPDX-License-Identifier: Apache-2.0
// The other end of the chip's serial line: bytes as 8N1 bits at a baud rate, in simulated time.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string_view>

#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

class ByteListener {
 public:
  ByteListener() = default;
  ByteListener(const ByteListener&) = delete;
  ByteListener& operator=(const ByteListener&) = delete;
  virtual ~ByteListener() = default;
  virtual void byte_received(sim::Clock now, std::uint8_t byte) = 0;
  // Everything given to send() is on the wire.
  virtual void all_sent([[maybe_unused]] sim::Clock now) {}
};

// What goes wrong on the wire, from a seed: shares of the bytes that get one flipped bit.
struct SerialFaults {
  double corrupted_bytes = 0;  // to the chip
  double corrupted_replies = 0;  // from the chip
  std::uint64_t seed = 1;
};

class SerialLine : public sim::Device {
 public:
  SerialLine(sim::ClockRate rate, std::uint32_t baud, sim::InputPins& inputs,
             const SerialFaults& faults = {});

  void set_listener(ByteListener& listener) { listener_ = &listener; }

  // From now on at another speed; a frame under way in either direction is lost, and so are the
  // bytes that wait: they were meant for the speed before.
  void set_baud(sim::Clock now, std::uint32_t baud);

  // The host is gone: the bytes that wait and the frame under way are lost, and the line is
  // low for so long, a break. Bytes that are sent meanwhile follow it.
  void hang_up(sim::Clock now, sim::Clock low_for);

  // Pulled out, both directions are dead: the chip's pin is idle, and what either end
  // sends is lost.
  void connect(bool connected);

  // Bytes to the chip, after those that still wait.
  void send(sim::Clock now, std::string_view bytes);
  std::size_t waiting_bytes() const { return waiting_.size(); }
  // Nothing waits and nothing is on the wire.
  bool quiet() const { return !sending_; }

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;
  void wake(sim::Clock now) override;

  std::uint64_t bytes_sent() const { return bytes_sent_; }
  std::uint64_t bytes_received() const { return bytes_received_; }
  std::uint64_t bytes_corrupted() const { return bytes_corrupted_; }
  std::uint64_t replies_corrupted() const { return replies_corrupted_; }
  // To the chip, while the cable was pulled.
  std::uint64_t bytes_lost() const { return bytes_lost_; }
  // Frames from the chip without a stop bit.
  std::uint64_t framing_errors() const { return framing_errors_; }

 private:
  sim::Clock after_half_bits(sim::Clock start, std::uint64_t half_bits) const;
  void schedule();
  void rest_until(sim::Clock end);
  void end_rest(sim::Clock now);
  void go_on(sim::Clock now);
  void start_frame(sim::Clock now);
  void drive_next_bit(sim::Clock now);
  void sample_bit(sim::Clock now);
  static std::uint8_t with_noise(std::uint8_t byte, std::mt19937_64& random, double share,
                                 std::uint64_t& count);

  sim::ClockRate rate_;
  std::uint32_t baud_;
  sim::InputPins& inputs_;
  SerialFaults faults_;
  std::mt19937_64 random_, reply_random_;  // one for each direction
  ByteListener* listener_ = nullptr;

  std::deque<std::uint8_t> waiting_;
  bool connected_ = true;
  bool sending_ = false;
  unsigned sent_bits_ = 0;  // of the frame on the wire
  std::uint16_t send_frame_ = 0;  // start bit lowest
  sim::Clock send_start_ = 0, send_at_ = sim::never;  // start: of frames without a pause between
  std::uint64_t frames_since_start_ = 0;

  bool transmit_level_ = true;  // the chip's pin
  bool receiving_ = false;
  unsigned received_bits_ = 0;
  std::uint16_t receive_frame_ = 0;
  sim::Clock receive_start_ = 0, receive_at_ = sim::never;

  std::uint64_t bytes_sent_ = 0, bytes_received_ = 0, bytes_corrupted_ = 0, framing_errors_ = 0;
  std::uint64_t replies_corrupted_ = 0, bytes_lost_ = 0;
};

}  // namespace devices
