// SPDX-License-Identifier: Apache-2.0
// The whole firmware on the fake chip, with a host that numbers its lines and waits for each
// answer, on a line that damages some of them; or with bytes as they come.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/fuzz/printer_model.hpp"
#include "tests/fuzz/property.hpp"

namespace {

using fuzz::require;

// Of one input, so that one that waits for heat does not take minutes.
constexpr unsigned most_passes = 400;
// Hosts expect a sign of life every two seconds.
constexpr double most_silence_s = 2.1;

struct Line {
  std::string text;
  unsigned wait_ms{};  // before it
  unsigned damaged_byte{};  // from 1; 0: none
  unsigned damaged_bit{};
  bool numbered = true;
};

// Bytes beyond ASCII say what happens to the line in which they stand.
Line line_of(std::span<const std::uint8_t> bytes) {
  Line line;
  for (const std::uint8_t byte : bytes) {
    if (byte < 0x80) {
      if (byte != '\r') line.text += static_cast<char>(byte);
    } else if (byte < 0x90) {
      line.wait_ms = (byte & 15U) * 60;
    } else if (byte < 0xD0) {
      line.damaged_byte = 1 + (byte - 0x90U) / 2;
      line.damaged_bit = byte % 7;
    } else if (byte < 0xE0) {
      line.numbered = false;
    }
  }
  // An M110 would need a host that counts on from there, and an empty line gets no answer among
  // numbered ones. A star in a line without number is no text for a host that numbers.
  const std::size_t first = line.text.find_first_not_of(" \t");
  if (first == std::string::npos || line.text.contains("110")) line.text = "M105";
  if (!line.numbered) std::ranges::replace(line.text, '*', '+');
  if (!line.numbered && line.text[line.text.find_first_not_of(" \t")] == 'N') line.numbered = true;
  return line;
}

class Host {
 public:
  explicit Host(fuzz::PrinterModel& printer) : printer_(printer) {}

  void print(std::span<const std::uint8_t> script) {
    if (!exchange({.text = "M110 N0"})) return;
    while (!script.empty()) {
      const auto end = std::ranges::find(script, '\n');
      const auto size = static_cast<std::size_t>(end - script.begin());
      const Line line = line_of(script.first(size));
      script = script.subspan(std::min(size + 1, script.size()));
      if (line.text.contains("M113")) hears_of_life_ = false;
      if (line.text.contains("M92") || line.text.contains("m92")) printer_.forget_travel();
      wait(line.wait_ms);
      if (!exchange(line)) return;
    }
  }

 private:
  // False where the printer has halted or the time is over.
  bool exchange(const Line& line);
  void transmit(const Line& line, bool damaged);
  bool pass();
  void wait(unsigned milliseconds);
  enum class Answer : std::uint8_t { none, ok, resend };
  Answer answer();

  fuzz::PrinterModel& printer_;
  std::uint32_t number_ = 0;
  unsigned passes_ = 0;
  double heard_at_ = 0;
  bool hears_of_life_ = true;
};

bool Host::pass() {
  printer_.pass();
  return ++passes_ < most_passes && !printer_.halted();
}

void Host::wait(unsigned milliseconds) {
  const double end = printer_.seconds() + milliseconds * 1e-3;
  while (milliseconds != 0 && printer_.seconds() < end && pass()) {
    require(answer() == Answer::none, "an answer came to no line");
  }
}

void Host::transmit(const Line& line, bool damaged) {
  std::string bytes = line.numbered ? fmt::format("N{} {}", number_, line.text) : line.text;
  if (line.numbered) {
    unsigned sum = 0;
    for (const char c : bytes) sum ^= static_cast<std::uint8_t>(c);
    bytes += fmt::format("*{}", sum);
  }
  if (damaged && line.numbered) {
    char& byte = bytes[(line.damaged_byte - 1) % bytes.size()];
    const char right = byte;
    byte = static_cast<char>(byte ^ 1 << line.damaged_bit);
    // A damaged M110 is requested as line 0, which this host no longer has; M118 and M100 are a
    // bit away, each another one.
    if (bytes.contains("M110")) byte = static_cast<char>(right ^ (line.damaged_bit == 0 ? 2 : 1));
  }
  bytes += '\n';
  printer_.chip().to_firmware.insert(printer_.chip().to_firmware.end(), bytes.begin(), bytes.end());
  heard_at_ = printer_.seconds();
}

Host::Answer Host::answer() {
  Answer answer = Answer::none;
  while (const auto reply = printer_.reply()) {
    heard_at_ = printer_.seconds();
    if (reply->starts_with("Resend: ")) {
      require(answer == Answer::none, "a Resend behind another answer");
      require(reply == fmt::format("Resend: {}", number_), "{} where {} was sent", *reply, number_);
      answer = Answer::resend;
    } else if (reply->starts_with("ok")) {
      require(answer != Answer::ok, "two answers to one line");
      if (answer == Answer::resend) return answer;
      answer = Answer::ok;
    }
  }
  require(answer != Answer::resend, "a Resend without its ok");
  return answer;
}

bool Host::exchange(const Line& line) {
  // Damaged once; a byte outside ASCII, and then a text that is no command, are requested again
  // once each.
  constexpr int most_transmissions = 5;
  for (int transmission = 0; transmission < most_transmissions; ++transmission) {
    const bool damaged = transmission == 0 && line.damaged_byte != 0 && line.numbered;
    transmit(line, damaged);
    Answer got = Answer::none;
    while (got == Answer::none) {
      if (!pass()) return false;
      got = answer();
      if (hears_of_life_) {
        require(printer_.seconds() - heard_at_ < most_silence_s, "no sign of life in \"{}\"",
                line.text);
      }
    }
    if (got == Answer::ok) {
      require(!damaged, "a damaged line was taken");
      number_ += line.numbered ? 1 : 0;
      return true;
    }
    require(line.numbered, "a line without number is asked for again");
  }
  fuzz::fail("line {} is asked for again and again: \"{}\"", number_, line.text);
}

void send_as_it_is(fuzz::PrinterModel& printer, std::span<const std::uint8_t> bytes) {
  unsigned passes = 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.contains("92")) printer.forget_travel();
  for (const std::uint8_t byte : bytes) {
    if (byte == 0xFF) {
      printer.chip().gap_before_next_byte = true;
    } else if (byte >= 0xF0) {
      const double end = printer.seconds() + (byte - 0xF0) * 0.05;
      while (printer.seconds() < end && ++passes < most_passes) printer.pass();
    } else {
      printer.chip().to_firmware.push_back(static_cast<char>(byte));
      if (byte == '\n') printer.pass();
    }
  }
  while (!printer.chip().to_firmware.empty() && ++passes < most_passes) printer.pass();
}

// Longer ones find nothing more and are slow.
constexpr std::size_t most_bytes = 600;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  size = std::min(size, most_bytes);
  if (size < 1) return 0;
  fuzz::PrinterModel printer(static_cast<fuzz::Prepared>(data[0] % fuzz::prepared_states));
  const std::span rest(data + 1, size - 1);
  if ((data[0] & 0x40) != 0) {
    send_as_it_is(printer, rest);
  } else {
    Host(printer).print(rest);
  }
  printer.check_at_the_end();
  return 0;
}
