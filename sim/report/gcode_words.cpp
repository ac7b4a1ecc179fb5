// SPDX-License-Identifier: Apache-2.0
// One pass over a line of G-code.
#include "sim/report/gcode_words.hpp"

#include <algorithm>
#include <cctype>

#include "sim/devices/digits.hpp"

namespace report {

namespace {

constexpr std::int64_t largest_whole = 1'000'000'000;
constexpr unsigned kept_decimals = 9;

using devices::is_digit;

bool is_blank(char character) { return character == ' ' || character == '\t'; }

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool at_end() {
    skip_comments();
    return text_.empty();
  }
  // Any character that is no letter stands for a word of its own, without a number.
  GcodeWord word() {
    const auto first = static_cast<unsigned char>(text_.front());
    GcodeWord word{static_cast<char>(std::toupper(first)), std::nullopt};
    text_.remove_prefix(1);
    skip_blanks();
    if (std::isalpha(first) != 0) word.value = number();
    return word;
  }

 private:
  void skip_blanks() {
    while (!text_.empty() && is_blank(text_.front())) text_.remove_prefix(1);
  }
  void skip_to_behind(char closing) {
    const std::size_t end = text_.find(closing, 1);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
  }
  void skip_comments() {
    for (skip_blanks(); !text_.empty(); skip_blanks()) {
      if (text_.front() == ';') {
        text_ = {};
      } else if (text_.front() == '(') {
        skip_to_behind(')');
      } else if (text_.front() == '"') {
        skip_to_behind('"');
      } else {
        return;
      }
    }
  }

  std::optional<std::int64_t> number() {
    std::string_view rest = text_;
    bool negative = false;
    if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) {
      negative = rest.front() == '-';
      rest.remove_prefix(1);
    }
    std::int64_t whole = 0, fraction = 0;
    bool any = false;
    for (; !rest.empty() && is_digit(rest.front()); rest.remove_prefix(1)) {
      whole = std::min(largest_whole, whole * 10 + (rest.front() - '0'));
      any = true;
    }
    if (!rest.empty() && rest.front() == '.') {
      rest.remove_prefix(1);
      unsigned decimals = 0;
      bool round_up = false;
      for (; !rest.empty() && is_digit(rest.front()); rest.remove_prefix(1), ++decimals) {
        any = true;
        if (decimals < kept_decimals) {
          fraction = fraction * 10 + (rest.front() - '0');
        } else if (decimals == kept_decimals) {
          round_up = rest.front() >= '5';
        }
      }
      for (; decimals < kept_decimals; ++decimals) fraction *= 10;
      fraction += round_up ? 1 : 0;
    }
    if (!any) return std::nullopt;
    text_ = rest;
    const std::int64_t value = whole * billionths + fraction;
    return negative ? -value : value;
  }

  std::string_view text_;
};

}  // namespace

GcodeWords::GcodeWords(std::string_view command) {
  Reader reader(command);
  while (!reader.at_end()) {
    words_.push_back(reader.word());
    if (words_.size() == 1 && (is('M', 117) || is('M', 118))) return;
  }
}

GcodeWords GcodeWords::without_first() const {
  GcodeWords rest;
  if (!words_.empty()) rest.words_.assign(words_.begin() + 1, words_.end());
  return rest;
}

bool GcodeWords::is(char letter, int code) const {
  return !words_.empty() && words_.front().letter == letter &&
         words_.front().value == code * billionths;
}

const GcodeWord* GcodeWords::find(char letter) const {
  for (std::size_t i = 1; i < words_.size(); ++i) {
    if (words_[i].letter == letter) return &words_[i];
  }
  return nullptr;
}

std::optional<std::int64_t> GcodeWords::value(char letter) const {
  const GcodeWord* word = find(letter);
  return word == nullptr ? std::nullopt : word->value;
}

}  // namespace report
