// SPDX-License-Identifier: Apache-2.0
// The boot loader's frames and session: bytes as they come from a line with pauses in it, and
// frames with a right checksum. Every answer is a whole frame, nothing outside the memory is
// written, and nothing is started that is not what `begin` announced.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "firmware/boot_loader/session.hpp"
#include "tests/fuzz/property.hpp"

namespace {

using namespace boot_loader;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t memory_address = 0x8000'0000;
constexpr std::size_t memory_bytes = 600;
constexpr std::size_t margin = 32;
constexpr std::size_t block_bytes = 64;  // of a program that fits
constexpr std::uint8_t untouched = 0xEE;
constexpr Session::ResetCode way_back{11, 12, 13, 14, 15, 16, 17, 18};

// By the definition, a byte at a time: apart from the loader's.
std::uint32_t crc(std::span<const std::uint8_t> bytes) {
  static constexpr auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t value = 0; value < entries.size(); ++value) {
      entries[value] = value;
      for (int bit = 0; bit < 8; ++bit) {
        const bool low = (entries[value] & 1) != 0;
        entries[value] = entries[value] >> 1 ^ (low ? 0xEDB88320U : 0);
      }
    }
    return entries;
  }();
  std::uint32_t state = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) state = state >> 8 ^ table[(state ^ byte) & 0xFF];
  return ~state;
}

void add_word(Bytes& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
}

class Loader {
 public:
  void put(std::uint8_t byte) {
    line_.push_back(byte);
    if (receiver_.receive(byte)) take_frame();
  }
  void silence() {
    receiver_.silence();
    line_.clear();
  }
  void send(Kind kind, const Bytes& payload) {
    Bytes frame{static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(payload.size()),
                static_cast<std::uint8_t>(payload.size() >> 8)};
    frame.insert(frame.end(), payload.begin(), payload.end());
    add_word(frame, crc(frame));
    put(marker);
    for (const std::uint8_t byte : frame) put(byte);
  }

 private:
  void take_frame();
  void note(const Frame& frame, Kind answer);

  std::array<std::uint8_t, memory_bytes + 2 * margin> room_ = [] {
    std::array<std::uint8_t, memory_bytes + 2 * margin> bytes{};
    bytes.fill(untouched);
    return bytes;
  }();
  std::span<std::uint8_t> memory_{std::span(room_).subspan(margin, memory_bytes)};
  Session session_{memory_, memory_address, memory_address, way_back};
  FrameReceiver receiver_;
  Bytes line_;  // since the last pause

  struct Announced {
    std::uint32_t place, bytes, checksum, entry;
  };
  std::optional<Announced> announced_;
  bool started_{};
};

void Loader::take_frame() {
  const Frame frame = receiver_.frame();
  const std::size_t length = 1 + header_bytes + frame.payload.size() + checksum_bytes;
  fuzz::require(frame.payload.size() <= most_payload_bytes, "a frame has {} bytes of payload",
                frame.payload.size());
  fuzz::require(line_.size() >= length, "a frame is longer than all that came");
  const auto raw = std::span(line_).last(length);
  fuzz::require(raw[0] == marker && crc(raw.subspan(1, length - 1 - checksum_bytes)) ==
                                        word_at(raw, length - checksum_bytes),
                "a frame with a wrong checksum was taken");

  const Answer answer = session_.handle(frame);
  FrameReceiver host;
  std::size_t frames = 0;
  for (const std::uint8_t byte : answer.bytes()) frames += host.receive(byte) ? 1u : 0u;
  fuzz::require(frames == 1 && host.silence(), "an answer is not one whole frame");
  note(frame, host.frame().kind);
}

void Loader::note(const Frame& frame, Kind answer) {
  const bool accepted = answer == Kind::accepted;
  if (frame.kind == Kind::begin && accepted) {
    announced_ = {word_at(frame.payload, 0) - memory_address, word_at(frame.payload, 4),
                  word_at(frame.payload, 8), word_at(frame.payload, 12)};
    started_ = false;
    fuzz::require(
        announced_->bytes <= memory_bytes && announced_->place <= memory_bytes - announced_->bytes,
        "a program that does not fit was accepted");
  }
  if (frame.kind == Kind::start && accepted) started_ = true;
  fuzz::require(session_.start_wanted() == started_,
                "the start is wanted without having been asked");
  fuzz::require(session_.entry().has_value() == (!announced_ || started_),
                "there is an entry to a program that is not whole");
  if (started_) {
    fuzz::require(
        crc(memory_.subspan(announced_->place, announced_->bytes)) == announced_->checksum,
        "a program is started that is not the one announced");
    fuzz::require(session_.entry() == announced_->entry &&
                      announced_->entry - memory_address - announced_->place < announced_->bytes,
                  "the entry is not in the program");
  } else if (announced_) {
    fuzz::require(std::ranges::equal(way_back, memory_.first(way_back.size())),
                  "a reset does not lead back to the loader");
  }
  const auto is_untouched = [](std::uint8_t byte) { return byte == untouched; };
  fuzz::require(std::ranges::all_of(std::span(room_).first(margin), is_untouched) &&
                    std::ranges::all_of(std::span(room_).last(margin), is_untouched),
                "a byte outside the memory was written");
}

// Longer ones find nothing more and are slow.
constexpr std::size_t most_bytes = 1500;

}  // namespace

// The first byte of each step says what it is: a pause, a frame of a kind with so many bytes, or
// bytes as they are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  size = std::min(size, most_bytes);
  std::span<const std::uint8_t> rest(data, size);
  const auto take = [&rest](std::size_t count) {
    const auto part = rest.first(std::min(count, rest.size()));
    rest = rest.subspan(part.size());
    return Bytes(part.begin(), part.end());
  };
  Loader loader;
  Bytes program;  // sent as one that fits
  while (!rest.empty()) {
    const std::uint8_t step = take(1)[0];
    const std::size_t count = step >> 3;
    switch (step & 7) {
      case 0:
        loader.silence();
        break;
      case 1:
        for (const std::uint8_t byte : take(1 + count)) loader.put(byte);
        break;
      case 2:
        loader.send(Kind::hello, take(count));
        break;
      case 3:
        loader.send(Kind::begin, take(count));
        break;
      case 4:
        loader.send(Kind::block, take(4 + count));
        break;
      case 5:
        loader.send(Kind::start, {});
        break;
      case 6: {  // announces what step 7 sends
        const Bytes choice = take(2);
        if (choice.size() < 2) break;
        program = take(1 + count * 9);
        if (program.empty()) break;
        Bytes payload;
        const std::uint32_t place = memory_address + choice[0];
        add_word(payload, place);
        add_word(payload, static_cast<std::uint32_t>(program.size()));
        add_word(payload, crc(program));
        add_word(payload, place + choice[1]);
        loader.send(Kind::begin, payload);
        break;
      }
      case 7: {
        const std::size_t from = std::min(program.size(), count * block_bytes);
        Bytes payload;
        add_word(payload, static_cast<std::uint32_t>(from));
        const std::size_t end = std::min(program.size(), from + block_bytes);
        payload.insert(payload.end(), program.begin() + static_cast<std::ptrdiff_t>(from),
                       program.begin() + static_cast<std::ptrdiff_t>(end));
        loader.send(Kind::block, payload);
        break;
      }
    }
  }
  return 0;
}
