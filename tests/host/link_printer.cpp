// SPDX-License-Identifier: Apache-2.0
// What the firmware's main loop does, with a list in place of motors and heaters.
#include "tests/host/link_printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace host_test {

using host_link::EmergencyCommand;

namespace {

units::Milliseconds link_time(std::chrono::milliseconds now) {
  return units::Milliseconds(now.count());
}

// The number behind `prefix`, up to a blank. None for another command, or one whose number noise
// has removed, which is to be refused.
std::optional<double> value_after(std::string_view prefix, std::string_view text) {
  if (!text.starts_with(prefix)) return std::nullopt;
  text.remove_prefix(prefix.size());
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool ends = end == text.data() + text.size() || *end == ' ';
  if (error != std::errc() || !ends || !(value >= 0 && value < 1'000)) return std::nullopt;
  return value;
}

}  // namespace

void LinkPrinter::restart() {
  link_.emplace();
  unsent_ = "start\n";
  halted_ = waiting_ = wait_is_over_ = false;
  skipped_ = 0;
  report_interval_ = {};
  in_hand_.reset();
  hotend_target_ = 0;
  heated_at_.reset();
}

void LinkPrinter::halt(std::string_view message) {
  unsent_ += std::string(message) + "\n";
  halted_ = true;
}

void LinkPrinter::receive(std::string_view bytes, std::chrono::milliseconds now) {
  if (halted_) return;
  link_->receive({bytes.data(), bytes.size()}, link_time(now));
}

void LinkPrinter::obey(const EmergencyCommand& command) {
  using Kind = EmergencyCommand::Kind;
  if (command.kind == Kind::kill) halt("Error:Printer halted. kill() called!");
  if (command.kind == Kind::cancel_wait && waiting_) wait_is_over_ = true;
  if (command.kind == Kind::cancel_wait && heated_at_) heated_at_ = std::chrono::milliseconds(0);
  if (command.kind == Kind::cancel) skipped_ = link_->waiting_lines();
}

// True at the end of an M109, and for all other lines.
bool LinkPrinter::is_heated(const std::string& text, std::chrono::milliseconds now) {
  const auto waited_for = value_after("M109 S", text);
  const bool waits = waited_for.has_value();
  const auto target = waits ? waited_for : value_after("M104 S", text);
  if (target && !heated_at_) {
    const double before = std::exchange(hotend_target_, *target);
    if (is_hot_ && before == hotend_target_) return true;
  }
  if (!waits) return true;
  if (!heated_at_) {
    heated_at_ = now + heating_time;
    is_hot_ = false;
    reported_at_ = now;
  }
  if (now < *heated_at_) {
    if (now - reported_at_ >= std::chrono::seconds(1)) {
      reported_at_ = now;
      say(temperatures() + " W:?");
    }
    return false;
  }
  is_hot_ = heated_at_ != std::chrono::milliseconds(0);  // not ended by M108
  heated_at_.reset();
  return true;
}

// False while it waits for its user, or for heat.
bool LinkPrinter::execute(const host_link::AcceptedLine& line, std::chrono::milliseconds now) {
  const std::string text(line.text);
  if (skipped_ == 0 && !is_heated(text, now)) return false;
  if (skipped_ > 0) {
    --skipped_;
    heated_at_.reset();
  } else if ((text == "M0" || text.starts_with("M0 ")) && !wait_is_over_) {
    waiting_ = true;
    return false;
  } else if (line.number && text.starts_with("M118 ")) {
    link_->say(text.substr(5));
    said_at_rest = at_rest_;
  } else if (!line.number) {
    if (!line.emergency) typed.push_back(text);
    if (const auto interval = value_after("M155 S", text)) {
      report_interval_ = std::chrono::seconds(static_cast<int>(*interval));
    }
  } else if (text != "M400" && !text.starts_with("M110")) {
    executed.push_back(text);
  }
  if (line.number) at_rest_ = text == "M400";
  waiting_ = wait_is_over_ = false;
  return true;
}

std::string LinkPrinter::temperatures() const {
  return fmt::format(" T:{:.2f} /{:.2f} B:20.25 /0.00 @:0 B@:0",
                     hotend_target_ > 0 && is_hot_ ? hotend_target_ : 21.5, hotend_target_);
}

void LinkPrinter::report(std::chrono::milliseconds now) {
  if (report_interval_.count() == 0 || now - reported_at_ < report_interval_) return;
  reported_at_ = now;
  say(temperatures());
}

std::string LinkPrinter::work(std::chrono::milliseconds now) {
  if (!halted_) {
    report(now);
    link_->update(link_time(now),
                  waiting_ ? host_link::Activity::paused_for_user : host_link::Activity::idle);
    while (const auto command = link_->emergency()) obey(*command);
    if (link_->query()) {
      link_->query_answered(temperatures());
    } else if (waiting_ ? wait_is_over_ : true) {
      const auto line = waiting_ || heated_at_ ? in_hand_ : link_->next_line();
      in_hand_ = line;
      if (line && execute(*line, now)) {
        link_->finished(line->text == "M105" ? temperatures() : "");
        in_hand_.reset();
      }
    }
    while (!link_->to_send().empty()) {
      unsent_.append(link_->to_send().data(), link_->to_send().size());
      link_->sent(link_->to_send().size());
    }
  }
  std::string sent = std::exchange(unsent_, {});
  if (const std::size_t ok = sent.find("ok\n"); lose_ok_ && ok != std::string::npos) {
    sent.erase(ok, 3);
    lose_ok_ = false;
  }
  return sent;
}

}  // namespace host_test
