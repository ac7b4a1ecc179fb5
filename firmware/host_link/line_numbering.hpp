// SPDX-License-Identifier: Apache-2.0
// Decides from number, checksum and history whether a framed line is taken, answered or
// requested again.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "host_link/line_number.hpp"
#include "host_link/line_receiver.hpp"
#include "units/quantity.hpp"

namespace host_link {

enum class LineError : std::uint8_t {
  none,
  wrong_checksum,
  wrong_number,
  no_checksum,
  too_long,
  unprintable,
  unfinished,
  corrupted,
  not_understood,
};

// What follows "echo:" and precedes ", asked for again". Not "Error:" as in Marlin: OctoPrint ends
// a print at an Error line in which noise has changed the words that it knows.
std::string_view describe(LineError error);

enum class Verdict : std::uint8_t {
  accept,  // the line that was waited for, or the first of a new numbering
  repeat,  // had been accepted before: wants its ok, not to be run
  refuse,  // request a resend
  ignore,  // drop without a word: a resend has just been requested and will be requested again
};

struct Judgement {
  Verdict verdict;
  LineError error{LineError::none};
};

class LineNumbering {
 public:
  // After a resend request, lines that cannot be the wanted one are ignored this long.
  static constexpr units::Milliseconds resend_patience{1000};
  // Repeats of old lines are explained by a resend request at most this long ago.
  static constexpr units::Milliseconds resend_memory{10'000};
  // A host that comes with its first lines sooner than this has not been restarted.
  static constexpr units::Milliseconds restart_pause{2000};

  // For a line with number or checksum. Does not accept it yet, but remembers what it refuses.
  Judgement judge(const ReceivedLine& line, units::Milliseconds now);
  // For a line that is known to be broken.
  Judgement judge_broken(const ReceivedLine& line, LineError error, units::Milliseconds now);
  // The line judged `accept` has been queued.
  void accepted(const ReceivedLine& line, units::Milliseconds now);
  // M110 N<last> without number and checksum.
  void restart_after(LineNumber last);
  // The last `count` lines taken begin with this one, which is no command: it and those after it
  // are wanted again. False, and nothing is changed, where the same has been wanted again before,
  // or where others were taken since.
  bool take_back(LineNumber number, std::string_view text, std::size_t count);
  // An unusable line came while a resend is awaited: request again after a time.
  void ignored() { ignored_since_resend_ = true; }
  // A resend request must be sent, as soon as there is room for it.
  void asked_for_resend(units::Milliseconds now);
  void resend_sent(units::Milliseconds now);

  // The next line of the numbering.
  LineNumber wanted() const;
  // What a resend requests: the wanted line, or the lost beginning of a new numbering.
  LineNumber asked_for() const { return state_ == State::start_awaited ? 0 : wanted(); }
  bool awaiting_resend() const { return state_ != State::in_order; }
  bool within_patience(units::Milliseconds now) const;
  bool must_ask_again(units::Milliseconds now) const;

  // Requests for the lost beginning of a numbering; after these the host is assumed not to have it.
  static constexpr std::uint8_t lost_start_requests = 6;

 private:
  enum class State : std::uint8_t {
    in_order,  // the next line comes, or the first
    line_awaited,  // it has been requested again
    start_awaited,  // a new numbering has begun, known to have come corrupted: its line 0 likewise
  };

  struct Taken {
    LineNumber number;
    std::uint32_t fingerprint;
    bool operator==(const Taken&) const = default;
  };
  static constexpr std::size_t history_length = 16;

  Judgement judge_number(const ReceivedLine& line, units::Milliseconds now);
  Judgement judge_after_lost_start(units::Milliseconds now);
  bool taken_before(LineNumber number, std::uint32_t fingerprint) const;
  bool opened_with(LineNumber number, std::uint32_t fingerprint) const;
  Judgement judge_restart(const ReceivedLine& line, units::Milliseconds now) const;
  Judgement judge_first_number(const ReceivedLine& line, units::Milliseconds now) const;
  Judgement refuse_or_ignore(units::Milliseconds now) const;
  bool begins_numbering(const ReceivedLine& line, units::Milliseconds now) const;
  bool may_be_sent_back(units::Milliseconds now) const;
  bool start_may_be_lost(const ReceivedLine& line) const;
  bool requested_within(units::Milliseconds time, units::Milliseconds now) const;
  void forget();
  void end_recovery();

  std::array<Taken, history_length> history_{};
  std::size_t history_size_{};
  std::size_t history_next_{};
  std::array<std::optional<std::uint32_t>, 2> openings_{};  // fingerprints of lines 0 and 1
  std::optional<Taken> unprintable_{};
  std::optional<Taken> taken_back_{};
  std::uint8_t lost_start_asked_{};  // so often since all was in order
  std::optional<LineNumber> refused_number_{};  // as far as it could be read
  LineNumber last_{};
  units::Milliseconds last_taken_{};
  std::optional<units::Milliseconds> asked_;  // the last time, if ever
  State state_{State::in_order};
  bool established_{};  // a line or an M110 has set the numbering since the start
  bool ignored_since_resend_{};
};

}  // namespace host_link
