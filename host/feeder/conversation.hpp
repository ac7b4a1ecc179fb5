// SPDX-License-Identifier: Apache-2.0
// A feeder's side of the serial line: what is sent next, and what replies mean. Pure logic: time
// comes in, bytes go out.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host/feeder/command_file.hpp"
#include "host/feeder/framing.hpp"
#include "host/feeder/homed_axes.hpp"
#include "host/feeder/journal.hpp"

namespace feeder {

using Time = std::chrono::milliseconds;  // from any origin

enum class Link : std::uint8_t {
  closed,  // no port
  asking,  // it is open; the printer has not answered, or is asked which line it wants
  ready,
};

class Conversation {
 public:
  // A silent printer with a line unanswered is asked which line it wants. Its busy lines come
  // every 2 s.
  static constexpr Time longest_silence{6000};
  static constexpr Time ask_interval{2500};
  static constexpr Time idle_interval{5000};
  // Line numbers begin at random above this, so that the printer's answer names the job too.
  static constexpr std::int64_t lowest_base = std::int64_t{1} << 20;
  static constexpr std::int64_t highest_base = std::int64_t{1} << 30;

  // Goes on with what the journal holds. `base`: makes a random base. `pause_limit`: the hotend of
  // a job that is paused for so long is switched off, and hot again before it goes on; 0: never.
  Conversation(Journal& journal, std::function<std::int64_t()> base, Time pause_limit = {});

  void opened(Time now);
  void closed();
  // A line from the printer, without its line end.
  void heard(std::string_view line, Time now);
  // To be called every 50 ms or so.
  void update(Time now);
  // What is to be written to the port, once.
  std::string take_output();

  // Each returns why it is refused, or nothing.
  std::string start(std::int64_t job, const std::string& file, std::int64_t commands);
  std::string pause();
  std::string resume();
  // Everything is switched off; a second one changes nothing, but without a port it gives up.
  // `job`: only this one, which may be over; without, what is being printed, or heaters that are
  // switched on.
  std::string cancel(std::optional<std::int64_t> job = std::nullopt);
  // The job's outcome has been noted elsewhere.
  std::string forget(std::int64_t job);
  // A person's line, sent between the lines of the job; what would disturb a running one is
  // refused, and why is returned.
  std::string send(std::string_view text);
  // M112, at once. The printer needs a reset then.
  void stop_everything();

  // For people: what the printer says besides its acknowledgements, and what was asked.
  std::function<void(std::string_view)> on_said;

  Link link() const { return link_; }
  const std::optional<Record>& record() const { return journal_.record(); }
  // Commands of the job that were acknowledged.
  std::int64_t done() const;
  const Temperatures& temperatures() const { return temperatures_; }
  // As far as this process has sent lines.
  const std::string& homed_axes() const { return homed_.axes(); }
  // The last report; nothing before the first, and after a loss of the printer.
  const std::optional<Position>& position() const { return position_; }
  bool waits_for_user() const { return waits_for_user_; }
  // In degrees, where a long pause has switched the hotend off; 0 where it has not.
  double hotend_to_restore() const { return record() ? record()->hotend_to_restore : 0; }
  // What is wrong with the journal, for people; or empty.
  const std::string& fault() const {
    return journal_.fault().empty() ? journal_.damage() : journal_.fault();
  }
  std::uint64_t resends() const { return resends_; }

 private:
  bool has_work() const { return record() && !is_over(record()->phase); }
  bool is_opening() const;
  void set_phase(Phase phase, std::string why = {});
  void begin_program();
  // Whatever ends a job but its own end: everything is switched off, then it has this outcome.
  void end_job(Phase outcome, std::string why);
  void begin_closing(Record record);
  void give_up_closing();
  bool may_heat() const;
  std::string text_of(std::int64_t index);
  std::int64_t length() const;
  std::string last_word() const;
  void ask_now();
  void ask(Time now);
  void become_ready(Time now);
  void answer_ok(Time now);
  void answer_resend(std::int64_t number, Time now);
  void go_on_from(std::int64_t number, Time now);
  void answer_fatal(std::string_view line, Time now);
  void handle_action(std::string_view action);
  bool is_last_word(std::string_view line) const;
  void watch_pause(Time now);
  bool must_heat_again() const;
  void heat_again(Time now);
  void answer_heating();
  void note_target();
  void note_hotend_to_restore(double celsius);
  void send_next(Time now);
  void send_line(Time now);
  void put(std::string_view text, Time now);
  // Reports come by themselves too: they are shown where a person has asked with this M code.
  void say_if_asked(std::int64_t code, std::string_view line);
  void say(std::string_view line) const {
    if (on_said) on_said(line);
  }

  Journal& journal_;
  std::function<std::int64_t()> make_base_;
  Time pause_limit_;
  std::optional<Time> cools_at_;  // of a job that is paused
  enum class HeatingAgain : std::uint8_t { no, waits, asks } heating_again_{};
  std::unique_ptr<CommandFile> file_;
  Link link_ = Link::closed;
  std::string output_;
  std::deque<std::string> typed_;  // lines of people that wait
  std::set<std::int64_t> asked_codes_;  // M105, M114 of people whose reports are due
  std::int64_t base_ = 0;  // of the lines that are being sent: the job's, or those that end it
  std::int64_t next_ = 1;  // index of the next one
  std::int64_t done_ = 0;
  int unanswered_ = 0;  // lines whose ok is due
  int asks_ = 0;  // in a row without an answer, where that ends something
  bool numbering_is_set_ = false;
  std::optional<Time> resend_at_;  // a Resend came, its ok is due
  // Line that the printer awaits again: until it comes it takes no M110 with another number.
  std::optional<std::int64_t> wanted_;
  std::optional<std::int64_t> strange_;  // number that was wanted and is none of the job's
  bool waits_for_user_ = false;
  Temperatures temperatures_;
  // Of the hotend: in the last report, and in two in a row, which no noise makes alike.
  std::optional<double> reported_target_, target_;
  HomedAxes homed_;
  std::optional<Position> position_;
  std::uint64_t resends_ = 0;
  // A report that comes by itself answers nothing.
  Time last_answered_{}, last_sent_{}, settled_at_{}, retried_at_{};
  std::optional<Time> asked_;  // nothing: ask at once
  std::optional<Time> report_at_;  // temperatures are to be reported by themselves from then on
};

}  // namespace feeder
