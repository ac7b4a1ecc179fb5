// SPDX-License-Identifier: Apache-2.0
// The loader's end of the protocol, frame by frame.
#include "firmware/boot_loader/session.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "firmware/boot_loader/checksum.hpp"

namespace {

using namespace boot_loader;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t address = 0x80000000, old_entry = address + 8;
constexpr Session::ResetCode way_back{11, 12, 13, 14, 15, 16, 17, 18};

Bytes words(std::initializer_list<std::uint32_t> values) {
  Bytes bytes(4 * values.size());
  std::size_t place = 0;
  for (const std::uint32_t value : values) {
    put_word(bytes, place, value);
    place += 4;
  }
  return bytes;
}

Bytes frame_of(Kind kind, const Bytes& payload) {
  Bytes frame{marker, static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(payload.size()),
              static_cast<std::uint8_t>(payload.size() >> 8)};
  frame.insert(frame.end(), payload.begin(), payload.end());
  const auto sum = words({checksum_of(std::span(frame).subspan(1))});
  frame.insert(frame.end(), sum.begin(), sum.end());
  return frame;
}

// Frames that come out of a receiver for these bytes.
unsigned frames_in(FrameReceiver& receiver, const Bytes& bytes) {
  unsigned count = 0;
  for (const std::uint8_t byte : bytes) count += receiver.receive(byte) ? 1u : 0u;
  return count;
}

class Loader {
 public:
  // What is said to a frame: its kind and payload.
  std::pair<Kind, Bytes> say(Kind kind, const Bytes& payload = {}) {
    const Answer answer = session.handle({kind, payload});
    FrameReceiver receiver;
    EXPECT_EQ(frames_in(receiver, {answer.bytes().begin(), answer.bytes().end()}), 1u);
    const Frame frame = receiver.frame();
    return {frame.kind, {frame.payload.begin(), frame.payload.end()}};
  }
  void expect_accepted(Kind kind, const Bytes& payload, std::uint32_t received) {
    const auto [answer, said] = say(kind, payload);
    ASSERT_EQ(answer, Kind::accepted);
    EXPECT_EQ(said[0], static_cast<std::uint8_t>(kind));
    EXPECT_EQ(word_at(said, 1), received);
  }
  void expect_refused(Kind kind, const Bytes& payload, Refusal reason) {
    const auto [answer, said] = say(kind, payload);
    ASSERT_EQ(answer, Kind::refused);
    EXPECT_EQ(static_cast<Refusal>(said[0]), reason);
  }
  void begin(const Bytes& program) {
    expect_accepted(
        Kind::begin,
        words({address, static_cast<std::uint32_t>(program.size()), checksum_of(program), address}),
        0);
  }

  Bytes memory = Bytes(1000, 0xEE);
  Session session{memory, address, old_entry, way_back};
};

Bytes block(std::uint32_t offset, const Bytes& bytes) {
  Bytes payload = words({offset});
  payload.insert(payload.end(), bytes.begin(), bytes.end());
  return payload;
}

const Bytes program{1, 2, 3, 4, 5, 6, 7};

bool leads_back(const Loader& loader) {
  return std::equal(way_back.begin(), way_back.end(), loader.memory.begin());
}

TEST(boot_loader, the_checksum_is_crc_32) {
  constexpr std::string_view digits = "123456789";
  EXPECT_EQ(checksum_of(Bytes(digits.begin(), digits.end())), 0xCBF43926u);
}

TEST(boot_loader, frames_are_found_between_other_bytes) {
  FrameReceiver receiver;
  Bytes line{'o', 'k', '\n', knock, knock};
  for (int i = 0; i < 3; ++i) {
    const Bytes frame = frame_of(Kind::hello, Bytes(static_cast<std::size_t>(i), marker));
    line.insert(line.end(), frame.begin(), frame.end());
    line.push_back(knock);
  }
  EXPECT_EQ(frames_in(receiver, line), 3u);
  EXPECT_TRUE(receiver.silence());
}

TEST(boot_loader, no_flipped_bit_of_a_frame_goes_unseen) {
  const Bytes frame = frame_of(Kind::block, block(512, program));
  for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
    Bytes corrupted = frame;
    corrupted[bit / 8] = static_cast<std::uint8_t>(corrupted[bit / 8] ^ 1u << bit % 8);
    FrameReceiver receiver;
    EXPECT_EQ(frames_in(receiver, corrupted), 0u) << bit;
    receiver.silence();
    EXPECT_EQ(frames_in(receiver, frame), 1u) << "after bit " << bit;
  }
}

TEST(boot_loader, a_frame_that_stops_is_damaged_and_forgotten_after_a_silence) {
  const Bytes frame = frame_of(Kind::block, block(0, program));
  for (std::size_t length = 1; length < frame.size(); ++length) {
    FrameReceiver receiver;
    const auto end = frame.begin() + static_cast<std::ptrdiff_t>(length);
    EXPECT_EQ(frames_in(receiver, {frame.begin(), end}), 0u);
    EXPECT_FALSE(receiver.silence());
    EXPECT_EQ(frames_in(receiver, frame), 1u);
  }
}

TEST(boot_loader, the_longest_frame_fits_and_a_longer_one_is_skipped) {
  FrameReceiver receiver;
  EXPECT_EQ(frames_in(receiver, frame_of(Kind::block, Bytes(most_payload_bytes))), 1u);
  EXPECT_EQ(frames_in(receiver, frame_of(Kind::block, Bytes(most_payload_bytes + 1))), 0u);
  EXPECT_FALSE(receiver.silence());
  EXPECT_EQ(frames_in(receiver, frame_of(Kind::hello, {})), 1u);
}

TEST(boot_loader, a_program_is_taken_in_blocks_and_started_when_it_is_whole) {
  Loader loader;
  EXPECT_EQ(loader.say(Kind::hello).first, Kind::identity);
  EXPECT_EQ(loader.session.entry(), old_entry);
  loader.begin(program);
  EXPECT_EQ(loader.session.entry(), std::nullopt);
  loader.expect_accepted(Kind::block, block(0, {1, 2, 3, 4}), 4);
  loader.expect_accepted(Kind::block, block(4, {5, 6, 7}), 7);
  EXPECT_FALSE(loader.session.start_wanted());
  loader.expect_accepted(Kind::start, {}, 7);
  EXPECT_TRUE(loader.session.start_wanted());
  EXPECT_EQ(loader.session.entry(), address);
  EXPECT_TRUE(std::equal(program.begin(), program.end(), loader.memory.begin()));
  EXPECT_EQ(loader.memory[Session::reset_bytes], 0xEE);
}

TEST(boot_loader, a_reset_leads_back_to_the_loader_until_the_program_is_whole) {
  Bytes longer(100);
  for (std::size_t i = 0; i < longer.size(); ++i) longer[i] = static_cast<std::uint8_t>(200 - i);
  Loader loader;
  loader.begin(longer);
  EXPECT_TRUE(leads_back(loader));
  loader.expect_accepted(Kind::block, block(0, longer), 100);
  EXPECT_TRUE(leads_back(loader));
  EXPECT_EQ(loader.memory[Session::reset_bytes], longer[Session::reset_bytes]);
  loader.expect_accepted(Kind::start, {}, 100);
  EXPECT_TRUE(std::equal(longer.begin(), longer.end(), loader.memory.begin()));
}

TEST(boot_loader, a_reset_leads_through_the_loader_to_a_program_that_lies_behind) {
  Loader loader;
  loader.expect_accepted(Kind::begin, words({address + 6, 7, checksum_of(program), address + 8}),
                         0);
  loader.expect_accepted(Kind::block, block(0, program), 7);
  EXPECT_TRUE(leads_back(loader));
  loader.expect_accepted(Kind::start, {}, 7);
  EXPECT_EQ(loader.memory[5], way_back[5]);
  EXPECT_EQ(loader.memory[6], program[0]);
  EXPECT_EQ(loader.memory[12], program[6]);
}

TEST(boot_loader, what_was_accepted_may_be_said_again) {
  Loader loader;
  loader.begin(program);
  loader.begin(program);
  loader.expect_accepted(Kind::block, block(0, {1, 2, 3, 4}), 4);
  loader.expect_accepted(Kind::block, block(0, {1, 2, 3, 4}), 4);
  loader.expect_accepted(Kind::block, block(4, {5, 6, 7}), 7);
  loader.expect_accepted(Kind::start, {}, 7);
  loader.expect_accepted(Kind::start, {}, 7);
}

TEST(boot_loader, blocks_out_of_order_or_beyond_the_end_are_refused) {
  Loader loader;
  loader.expect_refused(Kind::block, block(0, program), Refusal::not_begun);
  loader.expect_refused(Kind::start, {}, Refusal::not_begun);
  loader.begin(program);
  loader.expect_refused(Kind::block, block(4, {5}), Refusal::out_of_order);
  loader.expect_refused(Kind::block, block(0, Bytes(8)), Refusal::outside);
  loader.expect_refused(Kind::block, block(0, {}), Refusal::unknown);
  loader.expect_accepted(Kind::block, block(0, {1, 2}), 2);
  loader.expect_refused(Kind::block, block(0, {1}), Refusal::out_of_order);
  loader.expect_refused(Kind::start, {}, Refusal::incomplete);
  EXPECT_EQ(loader.session.entry(), std::nullopt);
}

TEST(boot_loader, a_program_that_does_not_fit_voids_nothing) {
  Loader loader;
  for (const auto& range :
       {words({address, 1001, 0, address}), words({address - 4, 8, 0, address}),
        words({address + 1000, 1, 0, address + 1000}), words({address, 0, 0, address}),
        words({address, 100, 0, address + 100}), words({address + 8, 100, 0, address}),
        words({address, 100, 0, address + 1}), words({address + 4, 0xFFFFFFFC, 0, address + 4})}) {
    loader.expect_refused(Kind::begin, range, Refusal::outside);
  }
  loader.expect_refused(Kind::begin, words({address, 100, 0}), Refusal::unknown);
  EXPECT_EQ(loader.session.entry(), old_entry);
  EXPECT_EQ(loader.memory, Bytes(1000, 0xEE));
}

TEST(boot_loader, memory_that_is_not_what_was_sent_is_not_started) {
  Loader loader;
  const Bytes fifty(50, 0x55);
  loader.begin(fifty);
  loader.expect_accepted(Kind::block, block(0, fifty), 50);
  loader.memory[33] ^= 0x10;
  loader.expect_refused(Kind::start, {}, Refusal::wrong_checksum);
  EXPECT_TRUE(leads_back(loader));
  EXPECT_FALSE(loader.session.start_wanted());
  EXPECT_EQ(loader.session.entry(), std::nullopt);
  // It may be filled again.
  loader.expect_accepted(Kind::block, block(0, fifty), 50);
  loader.expect_accepted(Kind::start, {}, 50);
}

TEST(boot_loader, an_unknown_frame_is_refused) {
  Loader loader;
  loader.expect_refused(static_cast<Kind>('?'), {}, Refusal::unknown);
}

}  // namespace
