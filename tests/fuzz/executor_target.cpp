// SPDX-License-Identifier: Apache-2.0
// A few lines of G-code, parsed and executed by the firmware on a chip on which nothing takes time
// (instant_chip), sent one by one, each after the answer to the one before.
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/fuzz/executor_model.hpp"
#include "tests/fuzz/property.hpp"

namespace {

using fuzz::require;

// Longer ones find nothing more and are slow.
constexpr std::size_t most_bytes = 120;

struct Line {
  std::string text;
  char letter{};  // of its command, upper case
  unsigned code{};
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// The link's own numbers and checksums are of other targets.
void take_line(std::span<const std::uint8_t> bytes, Line& line) {
  line.text.clear();
  line.letter = 0;
  line.code = 0;
  for (const std::uint8_t byte : bytes) {
    const char c = byte == '*' ? '+' : static_cast<char>(byte);
    if ((byte >= ' ' && byte <= '~') || byte == '\t') line.text += c;
  }
  bool comment = false, number = false;
  for (char& c : line.text) {
    if (number && c == '(') {
      return;
    }
    if (comment || c == '(') {
      comment = c != ')';
    } else if (c == ';') {
      return;
    } else if (line.letter == 0 && !is_blank(c)) {
      if (c == 'N' || c == 'n') c = 'G';
      line.letter = static_cast<char>(c & ~0x20);
    } else if (c >= '0' && c <= '9' && line.code < 100'000) {
      line.code = line.code * 10 + static_cast<unsigned>(c - '0');
      number = true;
    } else if (number || !is_blank(c)) {
      return;
    }
  }
}

bool is_one_of(const Line& line, char letter, std::initializer_list<unsigned> codes) {
  return line.letter == letter && std::ranges::find(codes, line.code) != codes.end();
}

class Host {
 public:
  explicit Host(fuzz::ExecutorModel& printer) : printer_(printer) {}

  void print(std::span<const std::uint8_t> script) {
    Line line;
    while (!script.empty()) {
      const auto end = std::ranges::find(script, '\n');
      const auto size = static_cast<std::size_t>(end - script.begin());
      take_line(script.first(size), line);
      script = script.subspan(std::min(size + 1, script.size()));
      if (line.letter == 0) continue;
      note(line);
      if (!exchange(line)) return printer_.check_halt();
    }
    printer_.check_place();
  }

 private:
  void note(const Line& line) {
    // By the letters alone, wherever they stand.
    if (is_one_of(line, 'M', {92, 211})) printer_.forget_travel();
    if (is_one_of(line, 'G', {53, 54, 55, 56, 57, 58, 59, 92}) ||
        is_one_of(line, 'M', {206, 207, 290, 428})) {
      printer_.forget_origin();
    }
    if (line.text.contains("//action")) {
      held_ = true;
    }
  }

  // False where the input ends.
  bool exchange(const Line& line) {
    const bool dwells = is_one_of(line, 'G', {4});
    const bool waits = dwells || held_ || is_one_of(line, 'M', {0, 1, 109, 190, 600, 601});
    if (printer_.exchange(line.text, waits)) return true;
    if (printer_.halted() || printer_.moves() || held_ || dwells) return false;
    require(waits, "no answer to \"{}\"", line.text);
    const bool ended = printer_.end_wait();
    require(ended || printer_.halted() || printer_.moves(), "\"{}\" does not end", line.text);
    return ended;
  }

  fuzz::ExecutorModel& printer_;
  bool held_ = false;  // by the host; the lines after it may wait
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  size = std::min(size, most_bytes);
  if (size < 1) return 0;
  fuzz::ExecutorModel printer(data[0]);
  Host(printer).print(std::span(data + 1, size - 1));
  return 0;
}
