// SPDX-License-Identifier: Apache-2.0
// Hello, begin, blocks in order, start. Everything may be sent twice: an answer may have been lost.
#include "boot_loader/session.hpp"

#include "boot_loader/checksum.hpp"

namespace boot_loader {

Answer::Answer(Kind kind, std::span<const std::uint8_t> payload) {
  bytes_[0] = marker;
  bytes_[1] = static_cast<std::uint8_t>(kind);
  bytes_[2] = static_cast<std::uint8_t>(payload.size());
  count_ = 1 + header_bytes;
  for (const std::uint8_t byte : payload) bytes_[count_++] = byte;
  put_word(bytes_, count_, checksum_of(std::span(bytes_).subspan(1, count_ - 1)));
  count_ += checksum_bytes;
}

Answer Session::refuse(Refusal reason) {
  const std::array<std::uint8_t, 1> payload{static_cast<std::uint8_t>(reason)};
  return {Kind::refused, payload};
}

Answer Session::accept(Kind kind) const {
  std::array<std::uint8_t, 5> payload{static_cast<std::uint8_t>(kind)};
  put_word(payload, 1, load_ ? load_->received : 0);
  return {Kind::accepted, payload};
}

Answer Session::handle(const Frame& frame) {
  switch (frame.kind) {
    case Kind::hello:
      return identify();
    case Kind::begin:
      return begin(frame.payload);
    case Kind::block:
      return take_block(frame.payload);
    case Kind::start:
      return start();
    default:
      return refuse(Refusal::unknown);
  }
}

Answer Session::identify() const {
  std::array<std::uint8_t, 12> payload{};
  put_word(payload, 0, version);
  put_word(payload, 4, address_);
  put_word(payload, 8, static_cast<std::uint32_t>(memory_.size()));
  return {Kind::identity, payload};
}

Answer Session::begin(std::span<const std::uint8_t> payload) {
  constexpr std::size_t expected_bytes = 16;
  if (payload.size() != expected_bytes) return refuse(Refusal::unknown);
  const Load load{.place = word_at(payload, 0) - address_,
                  .bytes = word_at(payload, 4),
                  .checksum = word_at(payload, 8),
                  .entry = word_at(payload, 12)};
  const bool fits =
      load.place < memory_.size() && load.bytes != 0 && load.bytes <= memory_.size() - load.place;
  if (!fits || load.entry - address_ - load.place >= load.bytes || (load.entry & 1) != 0) {
    return refuse(Refusal::outside);
  }
  load_ = load;
  entry_.reset();
  put_reset_code(way_back_);
  held_ = way_back_;
  start_wanted_ = false;
  return accept(Kind::begin);
}

Answer Session::take_block(std::span<const std::uint8_t> payload) {
  if (!load_) return refuse(Refusal::not_begun);
  if (payload.size() <= 4) return refuse(Refusal::unknown);
  const auto bytes = payload.subspan(4);
  const std::uint32_t offset = word_at(payload, 0);
  const auto count = static_cast<std::uint32_t>(bytes.size());
  // Of a block that is here already only the answer was lost.
  if (offset < load_->received && offset + count == load_->received) return accept(Kind::block);
  if (offset != load_->received) return refuse(Refusal::out_of_order);
  if (count > load_->bytes - load_->received) return refuse(Refusal::outside);
  std::size_t place = load_->place + offset;
  for (const std::uint8_t byte : bytes) put(place++, byte);
  load_->received += count;
  return accept(Kind::block);
}

void Session::put(std::size_t place, std::uint8_t byte) {
  (place < reset_bytes ? held_[place] : memory_[place]) = byte;
}

void Session::put_reset_code(const ResetCode& code) {
  for (std::size_t i = 0; i < reset_bytes; ++i) memory_[i] = code[i];
}

// Of what is in memory now, read again.
std::uint32_t Session::checksum() const {
  Checksum sum;
  for (std::size_t place = load_->place; place < load_->place + load_->bytes; ++place) {
    sum.add(place < reset_bytes ? held_[place] : memory_[place]);
  }
  return sum.value();
}

Answer Session::start() {
  if (!load_) return refuse(Refusal::not_begun);
  if (load_->received != load_->bytes) return refuse(Refusal::incomplete);
  if (checksum() != load_->checksum) {
    load_->received = 0;
    return refuse(Refusal::wrong_checksum);
  }
  put_reset_code(held_);
  entry_ = load_->entry;
  start_wanted_ = true;
  return accept(Kind::start);
}

}  // namespace boot_loader
