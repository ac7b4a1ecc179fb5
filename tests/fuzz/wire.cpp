// SPDX-License-Identifier: Apache-2.0
// Bits of the line are read back as a uart does it; the link's lines are answered as they come.
#include "tests/fuzz/wire.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>

#include "host_link/host_link.hpp"
#include "sim/devices/file_host.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {

namespace {

constexpr sim::ClockRate rate{1'000'000};
constexpr std::uint32_t baud = 100'000;
constexpr sim::Clock bit_clocks = 10;
constexpr sim::Clock clocks_per_ms = 1000;
// More than a file of 4 kB needs with every line damaged once.
constexpr unsigned most_flips = 6;

class Print : public devices::HostListener {
 public:
  Print(const std::vector<devices::FileCommand>& commands, std::span<const std::uint8_t> noise)
      : noise_(noise), host_(commands, line_, rate) {
    host_.add_listener(*this);
    for (const auto& command : commands) {
      if (!sets_numbering(command.text)) wanted_.push_back(command.text);
    }
    say("start\n");
  }

  void run();

  void command_sent(sim::Clock, std::size_t file_line, std::string_view command) override {
    if (file_line != 0) last_sent_ = command;
  }

 private:
  // M110, however it is written ("m 0110"): the firmware would count on from there.
  static bool sets_numbering(std::string_view text) {
    if (!text.starts_with('M') && !text.starts_with('m')) return false;
    text.remove_prefix(std::min(text.find_first_not_of(" \t", 1), text.size()));
    text.remove_prefix(std::min(text.find_first_not_of('0'), text.size()));
    return text.starts_with("110") &&
           (text.size() == 3 || !((text[3] >= '0' && text[3] <= '9') || text[3] == '.'));
  }

  void say(std::string_view reply) {
    for (const char c : reply) host_.byte_received(now_, static_cast<std::uint8_t>(c));
  }
  void carry_bytes();
  void receive(std::uint8_t byte);
  void serve_link();
  void take(const host_link::AcceptedLine& line);
  bool lies(std::string_view text) const;
  // With number and checksum the next line is longer than a line may be: it is answered only.
  bool may_be_left_out() const {
    const std::size_t number = arrived_ + 1;  // 0 is the host's own M110
    return fmt::format("N{} {}*123", number, wanted_[arrived_]).size() > host_link::max_line_length;
  }
  units::Milliseconds milliseconds() const {
    return units::Milliseconds(static_cast<std::int64_t>(now_ / clocks_per_ms));
  }

  std::span<const std::uint8_t> noise_;
  sim::InputPins pins_;
  devices::SerialLine line_{rate, baud, pins_};
  devices::FileHost host_;
  host_link::HostLink link_;
  sim::Clock now_ = 0;
  std::vector<std::string> wanted_;
  std::size_t arrived_ = 0;
  bool lied_ = false;
  bool waited_ = false;  // the host's M400 after the file has been taken
  std::string last_sent_;
  std::size_t lines_ = 0, place_ = 0;  // on the wire
  unsigned flips_ = 0;
};

void Print::carry_bytes() {
  while (line_.next_wake() != sim::never) {
    // In the middle of each bit after the start's edge.
    std::uint16_t frame = 0;
    const sim::Clock start = now_;
    for (unsigned bit = 0; bit < 10; ++bit) {
      const sim::Clock middle = start + bit * bit_clocks + bit_clocks / 2;
      while (line_.next_wake() <= middle) {
        now_ = std::max(now_, line_.next_wake());
        line_.wake(now_);
      }
      if (pins_.receive) frame = static_cast<std::uint16_t>(frame | 1U << bit);
    }
    const sim::Clock end = start + 10 * bit_clocks;
    require((frame & 1) == 0 && (frame >> 9 & 1) == 1, "a frame on the wire is broken");
    now_ = end;
    while (line_.next_wake() <= end) line_.wake(end);
    receive(static_cast<std::uint8_t>(frame >> 1));
  }
}

void Print::receive(std::uint8_t byte) {
  const std::uint8_t place = lines_ < noise_.size() ? noise_[lines_] : 0;
  ++place_;
  if (place != 0 && place_ == (place & 31U) && flips_ < most_flips) {
    ++flips_;
    const auto damaged = static_cast<std::uint8_t>(byte ^ 1U << (place >> 5));
    const char c = static_cast<char>(damaged);
    link_.receive({&c, 1}, milliseconds());
  } else {
    const char c = static_cast<char>(byte);
    link_.receive({&c, 1}, milliseconds());
  }

  if (byte == '\n') {
    ++lines_;
    place_ = 0;
  }
}

// A flip has made a line end of one byte, and what is after it begins with the line's own number,
// perhaps after blanks, and has the right checksum, since all in front has the XOR 0: no receiver
// can know.
bool Print::lies(std::string_view text) const {
  const std::string whole = fmt::format("N{} {}", arrived_ + 1, wanted_[arrived_]);
  if (flips_ == 0 || !whole.ends_with(text)) return false;
  unsigned sum = 0;
  for (std::size_t i = 0; i + text.size() < whole.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(whole[i]);
    sum ^= byte;
    const bool ends_line =
        std::has_single_bit(byte ^ unsigned{'\n'}) || std::has_single_bit(byte ^ unsigned{'\r'});
    const std::size_t rest = std::min(whole.find_first_not_of(' ', i + 1), whole.size());
    if (ends_line && sum == 0 && whole[rest] == 'N') return true;
  }
  return false;
}

void Print::take(const host_link::AcceptedLine& line) {
  if (line.text == "M110 N0") return;
  lied_ = lied_ || (arrived_ < wanted_.size() && lies(line.text));
  if (line.text.empty() || lied_) return;
  while (arrived_ < wanted_.size() && wanted_[arrived_] != line.text && may_be_left_out()) {
    ++arrived_;
  }
  if (line.text == "M400" && arrived_ == wanted_.size()) {
    waited_ = true;
    return;
  }
  require(arrived_ < wanted_.size(), "\"{}\" arrived behind the end of the file", line.text);
  require(wanted_[arrived_] == line.text, "\"{}\" arrived where \"{}\" was wanted", line.text,
          wanted_[arrived_]);
  ++arrived_;
}

void Print::serve_link() {
  while (link_.emergency()) {
  }
  link_.update(milliseconds(), host_link::Activity::idle);
  if (const auto line = link_.next_line()) take(*line);
  link_.finished();
  while (link_.query()) require(link_.query_answered(" T:0"), "no room for an answer");
  while (!link_.to_send().empty()) {
    const std::string bytes(link_.to_send().begin(), link_.to_send().end());
    link_.sent(bytes.size());

    say(bytes);
  }
}

void Print::run() {
  constexpr std::size_t most_passes = 20'000;
  for (std::size_t pass = 0; pass < most_passes && !host_.ended() && !lied_; ++pass) {
    carry_bytes();
    serve_link();
    if (line_.waiting_bytes() != 0 || line_.next_wake() != sim::never) continue;
    now_ += 50 * clocks_per_ms;
    if (host_.next_wake() <= now_) host_.wake(now_);
  }
  if (lied_) {
    return;  // an ok too many: what host and chip believe of the rest differs
  }
  require(host_.ended(), "the print has no end; the last line was \"{}\"", last_sent_);
  if (host_.state() == devices::HostState::faulted) {
    require(host_.fault().contains("boot loader"), "the print faulted: {}", host_.fault());
    return;
  }
  require(waited_, "the host ended before its M400; {} of {} lines arrived", arrived_,
          wanted_.size());
}

}  // namespace

void print_over_wire(const std::vector<devices::FileCommand>& commands,
                     std::span<const std::uint8_t> noise) {
  Print(commands, noise).run();
}

}  // namespace fuzz
