// SPDX-License-Identifier: Apache-2.0
// Parses lines by the protocol's definition, independently of the firmware.
#include "tests/fuzz/link_model.hpp"

#include <algorithm>
#include <charconv>

namespace fuzz {

namespace {

constexpr std::size_t longest_line = 128;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

unsigned exclusive_or(std::string_view text) {
  unsigned sum = 0;
  for (const char c : text) sum ^= static_cast<std::uint8_t>(c);
  return sum;
}

// What is in front of the last star, where the digits after it are its XOR.
std::optional<std::string_view> checked(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return std::nullopt;
  const std::string_view digits = trimmed(line.substr(star + 1));
  unsigned sum = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), sum);
  const bool number = end.ec == std::errc{} && end.ptr == digits.data() + digits.size();
  if (!number || sum != exclusive_or(line.substr(0, star))) return std::nullopt;
  return line.substr(0, star);
}

// The number after an N at the start, modulo 2^32, which is then taken off.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  if (!text.starts_with('N')) return std::nullopt;
  std::string_view rest = text.substr(1);
  while (rest.starts_with(' ') || rest.starts_with('\t')) rest.remove_prefix(1);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  std::int64_t number = 0;
  const auto end = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (end.ec != std::errc{}) return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(end.ptr - rest.data()));
  text = trimmed(rest);
  return static_cast<std::uint32_t>(number);
}

// Of an M code, however it is written ("m 0110"); otherwise -1.
int m_code(std::string_view text) {
  if (!text.starts_with('M') && !text.starts_with('m')) return -1;
  text = trimmed(text.substr(1));
  int code = -1;
  std::from_chars(text.data(), text.data() + text.size(), code);
  return code;
}

bool sets_numbering(std::string_view text) { return m_code(text) == 110; }

// It may be answered before the lines that wait, and is not delivered then.
bool only_asks(std::string_view text) {
  const int code = m_code(text);
  return code == 105 || code == 114 || code == 115;
}

}  // namespace

void LinkModel::put(char byte) {
  if (lost_before_next_) {
    link_.receive_fault(units::Milliseconds(now_ms_));
    disturbed_.push_back(line_.size());
    lost_before_next_ = false;
  }
  link_.receive({&byte, 1}, units::Milliseconds(now_ms_));
  link_.update(units::Milliseconds(now_ms_), activity_);
  if (byte != '\n' && byte != '\r') {
    line_ += byte;
    after_return_ = false;
    return;
  }
  const bool second = byte == '\n' && after_return_;
  after_return_ = byte == '\r';
  if (!second) end_line();
}

// Each part that it may have been split into.
void LinkModel::end_line() {
  ++ends_;
  for (const std::size_t part : parts_) {
    const bool disturbed =
        std::ranges::any_of(disturbed_, [part](std::size_t at) { return at >= part; });
    Raw raw{line_.substr(part), disturbed};
    // An M110 may set any number that stands in it; what is not delivered counts as well.
    std::string_view text = checked(raw.bytes).value_or(raw.bytes);
    text = trimmed(text);
    const auto own = take_number(text);
    if (own && (raw.bytes.size() > longest_line || only_asks(text))) restarts_.push_back(*own + 1);
    if (sets_numbering(text)) {
      if (own) restarts_.push_back(*own + 1);
      for (; !text.empty(); text.remove_prefix(1)) {
        std::string_view rest = text;
        if (const auto number = take_number(rest)) restarts_.push_back(*number + 1);
      }
    }
    lines_.push_back(std::move(raw));
  }
  line_.clear();
  parts_ = {0};
  disturbed_.clear();
}

void LinkModel::pause(int milliseconds) {
  now_ms_ += milliseconds;
  link_.update(units::Milliseconds(now_ms_), activity_);
  while (link_.emergency()) {
  }
  if (parts_.back() != line_.size()) parts_.push_back(line_.size());
}

void LinkModel::work_on(host_link::Activity activity) {
  activity_ = activity;
  pause(0);
}

void LinkModel::take_line() {
  if (const auto line = link_.next_line()) {
    deliver(*line);
    taken_ = true;
  }
}

void LinkModel::finish_lines(unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    take_line();
    if (!taken_) return;
    if (!link_.finished()) return;
    taken_ = false;
  }
}

void LinkModel::answer_query() {
  if (link_.query()) link_.query_answered(" T:20.00");
}

// Whether this raw line is one that says so.
bool LinkModel::came_so(const host_link::AcceptedLine& line, const Raw& raw) const {
  if (raw.disturbed || raw.bytes.size() > longest_line) return false;
  const auto framed = checked(raw.bytes);
  std::string_view text = trimmed(framed.value_or(raw.bytes));
  if (!framed && raw.bytes.contains('*') && !text.starts_with("M117") &&
      !text.starts_with("M118")) {
    return false;
  }
  if (!framed && text.starts_with('N')) return false;
  const auto number = framed ? take_number(text) : std::nullopt;
  return number == line.number && text == trimmed(line.text);
}

bool LinkModel::may_follow(const host_link::AcceptedLine& line) const {
  const std::uint32_t number = *line.number;
  if (number == 0 || number == 1 || sets_numbering(line.text)) return true;
  if (last_delivered_ && number == *last_delivered_ + 1) return true;
  return std::ranges::contains(restarts_, number);
}

void LinkModel::deliver(const host_link::AcceptedLine& line) {
  ++delivered_;
  const bool came = std::ranges::any_of(lines_, [&](const Raw& raw) { return came_so(line, raw); });
  require(came, "\"{}\" (number {}) was delivered and never came so", line.text,
          line.number ? std::to_string(*line.number) : "none");
  texts_.emplace_back(line.text);
  if (!line.number) return;
  require(may_follow(line), "line {} was delivered behind line {}", *line.number,
          last_delivered_ ? std::to_string(*last_delivered_) : "none");
  last_delivered_ = line.number;
}

void LinkModel::begin_numbered(std::uint32_t number) {
  last_sent_ = number;
  for (const char c : fmt::format("N{} ", number)) put(c);
}

void LinkModel::end_framed(unsigned error) {
  for (const char c : fmt::format("*{}", exclusive_or(line_) ^ error)) put(c);
  put('\n');
}

void LinkModel::hear(std::size_t most_bytes) {
  while (most_bytes != 0 && !link_.to_send().empty()) {
    const auto bytes = link_.to_send().first(std::min(most_bytes, link_.to_send().size()));
    for (const char c : bytes) {
      require((c >= ' ' && c <= '~') || c == '\n', "byte {} goes to the host",
              static_cast<unsigned char>(c));
      if (c != '\n') {
        heard_ += c;
        continue;
      }
      hear_line(heard_);
      heard_.clear();
    }
    most_bytes -= bytes.size();
    link_.sent(bytes.size());
  }
}

void LinkModel::hear_line(std::string_view line) {
  if (line.starts_with("ok")) ++oks_;
  if (!line.starts_with("Resend: ")) return;
  ++resends_;
  line.remove_prefix(std::string_view("Resend: ").size());
  std::int64_t number = 0;
  const auto end = std::from_chars(line.data(), line.data() + line.size(), number);
  require(end.ec == std::errc{} && end.ptr == line.data() + line.size(), "\"Resend: {}\" is none",
          line);
  asked_ = static_cast<std::uint32_t>(number);
}

void LinkModel::check() {
  const auto& counts = link_.statistics();
  require(counts.accepted == delivered_ + link_.waiting_lines() - (taken_ ? 1 : 0),
          "{} lines were accepted, {} delivered and {} wait", counts.accepted, delivered_,
          link_.waiting_lines());
  require(delivered_ <= lines_.size(), "{} lines delivered of {}", delivered_, lines_.size());
  require(link_.waiting_lines() <= host_link::LineQueue::capacity, "the queue overflows");
  require(resends_ <= counts.resends, "{} resends were heard and {} sent", resends_,
          counts.resends);
}

void LinkModel::put_text(std::string_view text) {
  for (const char c : text) put(c);
  end_framed(0);
}

void LinkModel::require_that_a_new_host_is_served() {
  // All that the old one left is done, and it is forgotten.
  activity_ = host_link::Activity::idle;
  for (int i = 0; i < 30; ++i) {
    hear(10'000);
    while (link_.query()) {
      if (!link_.query_answered(" T:20.00")) break;
    }
    finish_lines(8);
    // With each update some of what is owed is sent: of a flood of lines some hundred oks.
    for (int step = 0; step < 10; ++step) {
      pause(100);
      hear(10'000);
    }
    check();
  }
  hear(10'000);
  put('\n');  // as every host's connection begins, or the rest of a line is in the way of the first
  hear(10'000);
  texts_.clear();
  const std::vector<std::string> script{"M110 N0", "G28", "G1 X1", "G1 X2"};
  std::size_t next = 0;
  for (int i = 0; i < 20 && next < script.size(); ++i) {
    const std::size_t oks = oks_, resends = resends_;
    for (const char c : fmt::format("N{} ", next)) put(c);
    put_text(script[next]);
    finish_lines(8);
    hear(10'000);
    require(oks_ == oks + 1, "a line of a new host got {} answers", oks_ - oks);
    next = resends_ != resends ? asked_ : next + 1;
    require(next <= script.size(), "a new host is asked for line {}", next);
    pause(10);
    check();
  }
  require(std::ranges::equal(texts_, script), "of a new host {} lines came to be executed",
          texts_.size());
}

}  // namespace fuzz
