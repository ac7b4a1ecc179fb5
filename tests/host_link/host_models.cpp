// SPDX-License-Identifier: Apache-2.0
// The three hosts' sending rules, as read in their sources and measured.
#include "tests/host_link/host_models.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "tests/host_link/dialogue.hpp"
#include "units/digits.hpp"

namespace host_link::test {
namespace {

std::string lower(const std::string& text) {
  std::string result = text;
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

bool asks_for_resend(const std::string& line) {
  const std::string text = lower(line);
  return text.starts_with("resend") || text.starts_with("rs");
}

// The first or the last run of digits.
std::optional<int> number_in(const std::string& text, bool last) {
  using units::is_digit;
  const auto first = std::ranges::find_if(text, is_digit);
  if (first == text.end()) return std::nullopt;
  auto begin = first;
  auto end = std::find_if_not(first, text.end(), is_digit);
  if (last) {
    end = std::find_if(text.rbegin(), text.rend(), is_digit).base();
    begin = std::find_if_not(std::make_reverse_iterator(end), text.rend(), is_digit).base();
  }
  if (end - begin > 9) return std::nullopt;
  return std::stoi(std::string(begin, end));
}

bool contains_any(const std::string& text, std::initializer_list<const char*> parts) {
  return std::ranges::any_of(parts, [&](const char* part) { return text.contains(part); });
}

class Printcore : public HostModel {
 public:
  using HostModel::HostModel;

  void hear(const std::string& line, Milliseconds) override {
    if (asks_for_resend(line)) {
      if (const auto number = number_in(line, false)) resend_from_ = *number;
      clear_ = true;
    } else if (line.starts_with("ok") || line.starts_with("start") || line.starts_with("Grbl ")) {
      clear_ = true;
    }
  }

  std::string speak(Milliseconds now) override {
    if (!started_) {
      started_ = true;
      return frame(-1, "M110", " ");
    }
    if (!clear_ || done_) return "";
    clear_ = false;
    if (resend_from_ > -1 && resend_from_ < next_) {
      const auto index = static_cast<std::size_t>(resend_from_++);
      return frame(static_cast<int>(index), job_[index], " ");
    }
    resend_from_ = -1;
    if (now - polled_ >= poll_interval) {
      polled_ = now;
      return "M105\n";
    }
    if (next_ == static_cast<int>(job_.size())) {
      done_ = true;
      return "";
    }
    const int number = next_++;
    return frame(number, job_[static_cast<std::size_t>(number)], " ");
  }

  bool done() const override { return done_; }
  int first_number() const override { return 0; }

 private:
  static constexpr Milliseconds poll_interval = 3000;
  bool started_ = false;
  bool clear_ = false;
  bool done_ = false;
  int next_ = 0;
  int resend_from_ = -1;
  Milliseconds polled_ = 0;
};

class Octoprint : public HostModel {
 public:
  using HostModel::HostModel;

  void hear(const std::string& line, Milliseconds now) override {
    heard_ = now;
    if (ends_print(line)) ended_ = true;
    if (line.starts_with("ok")) {
      clear_ = true;
      simulate_ok_at_ = std::nullopt;
      return;
    }
    if (asks_for_resend(line)) {
      // Older lines than its history has, and lines to come, end the job (next_ alone is ignored);
      // here it then waits for another Resend.
      const auto number = number_in(line, false);
      if (number && *number < next_ && *number >= std::max(0, next_ - history)) {
        resend_ = *number;
      } else if (number != next_) {
        ended_ = ended_ || line.find_first_of("0123456789") != std::string::npos;
      }
      simulate_ok_at_ = now + 500;
      return;
    }
    // Whatever else comes between a Resend and its ok makes OctoPrint go on.
    if (simulate_ok_at_) simulate_ok_at_ = now;
  }

  std::string speak(Milliseconds now) override {
    if (hellos_ < 2) {
      ++hellos_;
      return frame(0, "M110 N0", " ");
    }
    if (simulate_ok_at_ && now >= *simulate_ok_at_) {
      simulate_ok_at_ = std::nullopt;
      clear_ = true;
    }
    if (now - heard_ >= time_out) {
      heard_ = now;
      return "M105\n";
    }
    if (!clear_ || done_) return "";
    clear_ = false;
    if (resend_ && *resend_ < next_) return line((*resend_)++);
    resend_ = std::nullopt;
    if (next_ > static_cast<int>(job_.size())) {
      done_ = true;
      return "";
    }
    return line(next_++);
  }

  bool done() const override { return done_; }
  int first_number() const override { return 1; }

 private:
  static constexpr int history = 50;
  static constexpr Milliseconds time_out = 18'000;

  // A reset of the printer, or an error that does not announce a Resend in words it knows.
  static bool ends_print(const std::string& line) {
    const std::string text = lower(line);
    if (line == "start" || text.starts_with("fatal:") || text.contains("kill() called")) {
      return true;
    }
    if (!line.starts_with("Error:") && !line.starts_with("!!")) return false;
    return !contains_any(text, {"line number", "checksum", "format error", "expected line"});
  }

  std::string line(int number) const {
    if (number == 0) return frame(0, "M110 N0", " ");
    return frame(number, job_[static_cast<std::size_t>(number - 1)], " ");
  }

  int hellos_ = 0;
  int next_ = 1;
  std::optional<int> resend_;
  bool clear_ = false;
  bool done_ = false;
  std::optional<Milliseconds> simulate_ok_at_;
  Milliseconds heard_ = 0;
};

class Cura : public HostModel {
 public:
  using HostModel::HostModel;

  void hear(const std::string& line, Milliseconds now) override {
    heard_ = now;
    if (line.starts_with("!!")) ended_ = true;
    if (line.find("ok") != std::string::npos) ++allowed_;
    if (asks_for_resend(line)) {
      // A line after the last of the job is the job's end.
      const auto number = number_in(line, true);
      if (number && *number <= static_cast<int>(job_.size())) {
        next_ = *number;
      } else {
        ended_ = ended_ || number;
      }
    }
  }

  std::string speak(Milliseconds now) override {
    if (now - heard_ >= blind_after) {
      heard_ = now;
      ++allowed_;
    }
    if (allowed_ == 0) return "";
    --allowed_;
    const int number = next_;
    if (number > static_cast<int>(job_.size())) {
      ++beyond_end_;
      return "";
    }
    beyond_end_ = 0;
    ++next_;
    return number == 0 ? frame(0, "M110", "")
                       : frame(number, job_[static_cast<std::size_t>(number - 1)], "");
  }

  // Only when all that was in flight has been answered.
  bool done() const override { return beyond_end_ >= in_flight; }
  int first_number() const override { return 1; }

 private:
  static constexpr int in_flight = 4;
  static constexpr Milliseconds blind_after = 6000;
  int allowed_ = in_flight;
  int next_ = 0;
  int beyond_end_ = 0;
  Milliseconds heard_ = 0;
};

}  // namespace

std::string HostModel::frame(int number, std::string_view text, std::string_view separator) {
  std::string line = "N" + std::to_string(number);
  line.append(separator).append(text).append("*?");
  return with_checksum(line) + "\n";
}

std::unique_ptr<HostModel> printcore(std::vector<std::string> job) {
  return std::make_unique<Printcore>(std::move(job));
}
std::unique_ptr<HostModel> octoprint(std::vector<std::string> job) {
  return std::make_unique<Octoprint>(std::move(job));
}
std::unique_ptr<HostModel> cura(std::vector<std::string> job) {
  return std::make_unique<Cura>(std::move(job));
}

}  // namespace host_link::test
