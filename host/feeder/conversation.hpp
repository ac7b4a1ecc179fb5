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
#include <string>
#include <string_view>

#include "host/feeder/command_file.hpp"
#include "host/feeder/framing.hpp"
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

  // Goes on with what the journal holds. `base`: makes a random base.
  Conversation(Journal& journal, std::function<std::int64_t()> base);

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
  std::string cancel();
  // The job's outcome has been noted elsewhere.
  std::string forget(std::int64_t job);
  // A person's line, sent between the lines of the job.
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
  bool waits_for_user() const { return waits_for_user_; }
  std::uint64_t resends() const { return resends_; }

 private:
  bool has_work() const { return record() && !is_over(record()->phase); }
  bool is_opening() const;
  void set_phase(Phase phase, std::string why = {});
  void begin_program();
  std::string text_of(std::int64_t index);
  std::int64_t length() const;
  std::string last_word() const;
  void ask_now();
  void ask(Time now);
  void become_ready(Time now);
  void answer_ok(Time now);
  void answer_resend(std::int64_t number, Time now);
  void go_on_from(std::int64_t number, Time now);
  void answer_fatal(std::string_view line);
  void handle_action(std::string_view action);
  bool is_last_word(std::string_view line) const;
  void send_next(Time now);
  void send_line(Time now);
  void put(std::string_view text, Time now);
  void say(std::string_view line) const {
    if (on_said) on_said(line);
  }

  Journal& journal_;
  std::function<std::int64_t()> make_base_;
  std::unique_ptr<CommandFile> file_;
  Link link_ = Link::closed;
  std::string output_;
  std::deque<std::string> typed_;  // lines of people that wait
  std::int64_t base_ = 0;  // of the lines that are being sent: the job's, or those that end it
  std::int64_t next_ = 1;  // index of the next one
  std::int64_t done_ = 0;
  int unanswered_ = 0;  // lines whose ok is due
  int openings_ = 0;  // tries to set the numbering
  bool numbering_is_set_ = false;
  std::optional<Time> resend_at_;  // a Resend came, its ok is due
  std::optional<std::int64_t> strange_;  // number that was wanted and is none of the job's
  bool waits_for_user_ = false;
  Temperatures temperatures_;
  std::uint64_t resends_ = 0;
  Time last_heard_{}, last_sent_{}, settled_at_{};
  std::optional<Time> asked_;  // nothing: ask at once
  std::optional<Time> report_at_;  // temperatures are to be reported by themselves from then on
};

}  // namespace feeder
