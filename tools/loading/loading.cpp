// SPDX-License-Identifier: Apache-2.0
// One frame, one answer; without an answer the frame again.
#include "tools/loading/loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "firmware/boot_loader/checksum.hpp"
#include "firmware/boot_loader/frame_receiver.hpp"

namespace loading {

namespace {

using namespace boot_loader;
using std::chrono::milliseconds;
using Bytes = std::vector<std::uint8_t>;

constexpr milliseconds asking_interval{250};
constexpr unsigned times_requested = 20;  // 5 s, for a move that is under way
constexpr milliseconds knocking_interval{5};  // the loader listens for 10 ms after a reset
constexpr unsigned times_knocked = 6000;  // 30 s
constexpr milliseconds answer_time{400};
// The checksum of 60 KiB takes a chip of 4 MHz about a second.
constexpr milliseconds check_time{3000};
constexpr unsigned most_attempts = 10;
// Each further answer is waited for twice as long, up to 8 times: a simulated chip on a busy
// machine takes that long for a block, and frames that are sent too early only make it later.
constexpr unsigned most_doublings = 3;
constexpr unsigned most_restarts = 3;
// Reading must end also on a line of 1 Mbaud that is never idle.
constexpr std::size_t most_bytes_per_ms = 100;

void add_word(Bytes& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
}

Bytes frame_of(Kind kind, const Bytes& payload) {
  Bytes frame{marker, static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(payload.size()),
              static_cast<std::uint8_t>(payload.size() >> 8)};
  frame.insert(frame.end(), payload.begin(), payload.end());
  add_word(frame, checksum_of(std::span(frame).subspan(1)));
  return frame;
}

const char* meaning_of(Refusal reason) {
  switch (reason) {
    case Refusal::damaged:
      return "the frame came damaged";
    case Refusal::unknown:
      return "it does not know the frame";
    case Refusal::outside:
      return "the program does not fit into the memory";
    case Refusal::not_begun:
      return "no load was begun";
    case Refusal::out_of_order:
      return "a block is missing";
    case Refusal::incomplete:
      return "the program is not complete";
    case Refusal::wrong_checksum:
      return "the checksum of the whole is wrong";
  }
  return "for a reason that is not known";
}

class Host {
 public:
  Host(ByteStream& stream, const Progress& progress) : stream_(stream), progress_(progress) {}

  void connect(const Program& program);
  void load(const Program& program);
  const Figures& figures() const { return figures_; }

 private:
  struct Reply {
    Kind kind{};
    Bytes payload;
  };

  std::optional<Reply> next_reply(milliseconds timeout);
  bool answers(const Bytes& greeting, milliseconds timeout);
  void exchange(Kind kind, const Bytes& payload, std::uint32_t received_then,
                milliseconds timeout = answer_time);
  void transfer(const Program& program);

  ByteStream& stream_;
  const Progress& progress_;
  FrameReceiver receiver_;
  Bytes unread_;
  Figures figures_;
  std::uint32_t memory_end_{};
};

// A refusal that repeating the frame does not resolve.
struct Refused {
  Refusal reason;
};

std::optional<Host::Reply> Host::next_reply(milliseconds timeout) {
  const std::size_t most_bytes =
      most_bytes_per_ms * static_cast<std::size_t>(timeout.count()) + most_bytes_per_ms;
  for (std::size_t bytes_read = 0;;) {
    while (!unread_.empty()) {
      const std::uint8_t byte = unread_.front();
      unread_.erase(unread_.begin());
      if (!receiver_.receive(byte)) continue;
      const Frame frame = receiver_.frame();
      return Reply{frame.kind, {frame.payload.begin(), frame.payload.end()}};
    }
    std::array<std::uint8_t, 256> bytes;
    const std::size_t count = stream_.read(bytes, timeout);
    bytes_read += count;
    if (count == 0 || bytes_read > most_bytes) {
      receiver_.silence();
      return std::nullopt;
    }
    unread_.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

bool Host::answers(const Bytes& greeting, milliseconds timeout) {
  stream_.write(greeting);
  while (const auto reply = next_reply(timeout)) {
    if (reply->kind != Kind::identity || reply->payload.size() != 12) continue;
    if (word_at(reply->payload, 0) != version) {
      throw LoadFailed("the chip's boot loader is of another version");
    }
    memory_end_ = word_at(reply->payload, 4) + word_at(reply->payload, 8);
    return true;
  }
  return false;
}

void Host::connect(const Program& program) {
  progress_.say("asking for the boot loader");
  const Bytes hello = frame_of(Kind::hello, {});
  constexpr std::string_view request = "\nM997\n";
  Bytes asking(request.begin(), request.end());
  asking.insert(asking.end(), hello.begin(), hello.end());
  bool connected = false;
  for (unsigned i = 0; i < times_requested && !connected; ++i) {
    connected = answers(asking, asking_interval);
  }
  if (!connected) progress_.say("no answer: reset the board now");
  Bytes knocking(2 * std::size_t{knocks}, knock);
  knocking.insert(knocking.end(), hello.begin(), hello.end());
  for (unsigned i = 0; i < times_knocked && !connected; ++i) {
    connected = answers(knocking, knocking_interval);
  }
  if (!connected) throw LoadFailed("no boot loader answers");
  if (program.address + program.bytes.size() > memory_end_) {
    throw LoadFailed(meaning_of(Refusal::outside));
  }
}

// Until this kind of frame is accepted and the chip has so many bytes.
void Host::exchange(Kind kind, const Bytes& payload, std::uint32_t received_then,
                    milliseconds timeout) {
  const Bytes frame = frame_of(kind, payload);
  for (unsigned attempt = 0; attempt < most_attempts; ++attempt) {
    if (attempt != 0) ++figures_.repeated_frames;
    stream_.write(frame);
    const milliseconds time = timeout * (1U << std::min(attempt, most_doublings));
    while (const auto reply = next_reply(time)) {
      if (reply->kind == Kind::accepted && reply->payload.size() == 5 &&
          reply->payload[0] == static_cast<std::uint8_t>(kind) &&
          word_at(reply->payload, 1) == received_then) {
        return;
      }
      if (reply->kind != Kind::refused || reply->payload.size() != 1) continue;
      const auto reason = static_cast<Refusal>(reply->payload[0]);
      if (reason != Refusal::damaged) throw Refused{reason};
      break;
    }
  }
  throw LoadFailed("the boot loader does not answer any more; what it has is not started");
}

void Host::transfer(const Program& program) {
  const auto size = static_cast<std::uint32_t>(program.bytes.size());
  Bytes beginning;
  for (const std::uint32_t word :
       {program.address, size, checksum_of(program.bytes), program.entry}) {
    add_word(beginning, word);
  }
  exchange(Kind::begin, beginning, 0);
  for (std::uint32_t offset = 0; offset < size;) {
    const auto count = std::min<std::uint32_t>(most_block_bytes, size - offset);
    Bytes block;
    add_word(block, offset);
    const auto first = program.bytes.begin() + offset;
    block.insert(block.end(), first, first + count);
    offset += count;
    exchange(Kind::block, block, offset);
    progress_.sent(offset);
  }
  progress_.say("checking");
  exchange(Kind::start, {}, size, check_time);
}

void Host::load(const Program& program) {
  for (;;) {
    progress_.say(
        fmt::format("loading {} bytes to {:#010x}", program.bytes.size(), program.address));
    try {
      return transfer(program);
    } catch (const Refused& refused) {
      const bool hopeless =
          refused.reason == Refusal::outside || refused.reason == Refusal::unknown;
      if (hopeless || figures_.restarts == most_restarts) {
        throw LoadFailed(fmt::format("the boot loader refuses: {}", meaning_of(refused.reason)));
      }
      ++figures_.restarts;
    }
  }
}

}  // namespace

Figures load(ByteStream& stream, const Program& program, const Progress& progress) {
  Host host(stream, progress);
  host.connect(program);
  host.load(program);
  return host.figures();
}

}  // namespace loading
